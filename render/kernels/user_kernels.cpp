// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/kernels/user_kernels.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <string>

#include "core/base/error.h"
#include "core/material/brdf_file.h"
#include "kernels/check_brdf_text.h"
#include "kernels/irradiance_text.h"
#include "kernels/reshade_text.h"
#include "render/kernels/glsl_compiler.h"
#include "shaders/brdf/registry.h"

namespace render {

namespace {

/// Number of the string (#line) that a message refers to: the files are 0, 1, ...; the rest is the program's.
constexpr int kOwnString = 99;

const char* kernelText(UserKernel kernel) {
    switch (kernel) {
        case UserKernel::Reshade:
            return reshade_text;
        case UserKernel::Irradiance:
            return irradiance_text;
        case UserKernel::CheckBrdf:
            return check_brdf_text;
    }
    return "";
}

/// Helpers that the files' code calls. Each call of their functions has a budget of steps for all its loops.
constexpr const char* kHelpers = R"glsl(
const int kUserSteps = 256;
int userSteps;
BrdfParams userParams;
bool user_step() {
    if (++userSteps <= kUserSteps) return true;
    userFaults |= kUserLoops;
    return false;
}
int user_index(int i, int count) { return clamp(i, 0, count - 1); }
int user_index(uint i, int count) { return int(min(i, uint(count - 1))); }
vec3 user_fresnel(float cosine) { return fresnel_specular(userParams, cosine); }
)glsl";

/// The interface of the files to the kernel; EVALUATE, PDF and SAMPLE stand for a case per file.
constexpr const char* kDispatch = R"glsl(
vec3 user_eval(BrdfParams b, vec3 wo, vec3 wi) {
    if (!(wo.z > 0.0) || !(wi.z > 0.0)) return vec3(0.0);
    user_begin(b);
    vec3 f = vec3(0.0);
    switch (int(b.type)) { EVALUATE default: break; }
    return f;
}
float user_pdf(BrdfParams b, vec3 wo, vec3 wi) {
    if (!(wo.z > 0.0) || !(wi.z > 0.0)) return 0.0;
    user_begin(b);
    float f = 0.0;
    switch (int(b.type)) { PDF default: break; }
    return f;
}
vec3 user_sample(BrdfParams b, vec3 wo, vec2 u) {
    vec3 f = vec3(0.0, 0.0, -1.0);
    if (!(wo.z > 0.0)) return f;
    user_begin(b);
    switch (int(b.type)) { SAMPLE default: break; }
    if (abs(dot(f, f) - 1.0) < 1e-3) return f;
    userFaults |= kUserDirection;
    return vec3(0.0, 0.0, -1.0);
}
vec3 user_weight(BrdfParams b, vec3 wo, vec3 wi) {
    float pdf = user_pdf(b, wo, wi);
    if (!(pdf > 0.0)) return vec3(0.0);
    return user_eval(b, wo, wi) * (wi.z / pdf);
}
)glsl";

std::string replaced(std::string_view text, std::string_view what, std::string_view by) {
    std::string result;
    for (std::size_t at = 0;;) {
        const std::size_t next = text.find(what, at);
        result += text.substr(at, next - at);
        if (next == std::string_view::npos) return result;
        result += by;
        at = next + what.size();
    }
}

std::string prefixOf(std::size_t i) { return replaced(core::kUserBrdfPrefix, "@", std::to_string(i)); }

std::string lineDirective(int string) { return "\n#line 1 " + std::to_string(string) + "\n"; }

/// Parameters of file `i` are globals, which `user_beginI` sets.
std::string parametersOf(const core::UserBrdf& file, std::size_t i) {
    static constexpr std::array<const char*, 3> kMembers{"values", "values2", "values3"};
    const std::string prefix = prefixOf(i);
    std::string globals;
    std::string begin = "void user_begin" + std::to_string(i) + "(BrdfParams b) {\n";
    for (std::size_t p = 0; p < file.params.size(); ++p) {
        globals += "float " + prefix + file.params[p].key + ";\n";
        begin += prefix + file.params[p].key + " = b." + kMembers.at(p / 4) + "." + "xyzw"[p % 4] + ";\n";
    }
    for (const auto& [used, name] : {std::pair{file.usesAlbedo, "albedo"}, std::pair{file.usesSpecular, "specular"}}) {
        if (!used) continue;
        globals += "vec3 " + prefix + name + ";\n";
        begin += prefix + name + " = b." + name + ".xyz;\n";
    }
    if (file.usesSpecular) begin += "userParams = b;\n";
    return globals + begin + "}\n";
}

std::string cases(std::size_t files, const char* call) {
    std::string result;
    for (std::size_t i = 0; i < files; ++i) {
        const std::string id = std::to_string(BRDF_USER + i);
        result.append("case ").append(id).append(": if ((kBrdfSet & (1u << ").append(id).append(")) != 0u) f = ");
        result.append(prefixOf(i)).append(call).append("; break; ");
    }
    return result;
}

std::string kernelWith(UserKernel kernel, const UserFiles& files) {
    std::string text = std::string(kernelText(kernel)) + kHelpers;
    text.insert(text.find('\n'), lineDirective(kOwnString));  // behind #version
    std::string begin;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::string number = std::to_string(i);
        text += parametersOf(*files[i], i) + lineDirective(static_cast<int>(i)) +
                replaced(files[i]->code, "@", number) + lineDirective(kOwnString);
        begin += "if (b.type == " + std::to_string(BRDF_USER + i) + "u) user_begin" + number + "(b); ";
    }
    text += "void user_begin(BrdfParams b) { userSteps = 0; " + begin + "}\n";
    std::string dispatch = replaced(kDispatch, "EVALUATE", cases(files.size(), "evaluate(wo, wi)"));
    dispatch = replaced(dispatch, "PDF", cases(files.size(), "pdf(wo, wi)"));
    return text + replaced(dispatch, "SAMPLE", cases(files.size(), "sample(wo, u)"));
}

/// "ERROR: 0:12: 'user0nfoo' : undeclared identifier" as "PATH:12: 'foo' : undeclared identifier".
[[noreturn]] void refuse(const std::string& log, const UserFiles& files) {
    constexpr std::string_view kMark = "ERROR: ";
    const std::size_t first = log.find(kMark);
    std::string message = first == std::string::npos ? log : log.substr(first + kMark.size());
    message = message.substr(0, message.find('\n'));
    for (std::size_t i = 0; i < files.size(); ++i) message = replaced(message, prefixOf(i), "");
    const std::size_t colon = message.find(':');
    const std::size_t second = colon == std::string::npos ? colon : message.find(':', colon + 1);
    if (second == std::string::npos) throw core::Error(core::ErrorKind::Input, files.at(0)->path + ": " + message);
    while (message.ends_with(' ')) message.pop_back();
    const std::size_t string = std::strtoul(message.c_str(), nullptr, 10);
    const bool own = string < files.size();
    throw core::Error(core::ErrorKind::Input,
                      files.at(own ? string : 0)->path + message.substr(own ? colon : second) + ".");
}

}  // namespace

UserFiles placeUserBrdfs(const core::Scene& scene, std::span<kernel::SegmentShading> shading) {
    UserFiles files;
    for (const core::Segment& segment : scene.segments) {
        if (!segment.edit || !core::usable(*segment.edit) || !segment.edit->brdfFile) continue;
        const auto& user = segment.edit->brdfFile->user;
        if (!user) continue;
        const auto found = std::find(files.begin(), files.end(), user);
        shading[segment.label].brdf.type = BRDF_USER + static_cast<std::uint32_t>(found - files.begin());
        if (found == files.end()) files.push_back(user);
    }
    if (files.size() > BRDF_USER_COUNT)
        throw core::Error(
            core::ErrorKind::Input,
            core::Message("messages", "The edits use %1 BRDFs from .brdf.glsl files, expected at most %2 at a time.")
                .with(files.size(), BRDF_USER_COUNT));
    return files;
}

std::vector<std::uint32_t> compileUserKernel(UserKernel kernel, const UserFiles& files) {
    CompiledGlsl compiled = compileGlsl(kernelWith(kernel, files), kOwnString);
    if (compiled.code.empty()) refuse(compiled.log, files);
    return std::move(compiled.code);
}

void UserKernels::want(const UserFiles& files, bool irradiance) {
    files_ = files;
    irradiance_ = irradiance && !files.empty();
    if (files_.empty()) code_ = nullptr;
    if (!current() && !compiling_.valid()) start();
}

void UserKernels::start() {
    compiling_ = std::async(std::launch::async, [files = files_, irradiance = irradiance_] {
        auto code = std::make_shared<Code>();
        code->files = files;
        code->reshade = compileUserKernel(UserKernel::Reshade, files);
        if (irradiance) code->irradiance = compileUserKernel(UserKernel::Irradiance, files);
        return std::shared_ptr<const Code>(std::move(code));
    });
}

bool UserKernels::current() const {
    if (files_.empty()) return true;
    return code_ && code_->files == files_ && (!irradiance_ || !code_->irradiance.empty());
}

bool UserKernels::ready(double seconds) {
    const auto wait = std::chrono::duration<double>(seconds);
    while (!current()) {
        if (!compiling_.valid()) start();
        if (compiling_.wait_for(wait) != std::future_status::ready) return false;
        std::shared_ptr<const Code> done = compiling_.get();
        if (done->files == files_) code_ = std::move(done);
    }
    return true;
}

}  // namespace render
