// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/kernels/glsl_compiler.h"

#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

namespace render {

namespace {

/// Looks for divisions of integers.
class DivisionFinder : public glslang::TIntermTraverser {
  public:
    explicit DivisionFinder(int trustedString) : trustedString_(trustedString) {}

    bool visitBinary(glslang::TVisit /*visit*/, glslang::TIntermBinary* node) override {
        const glslang::TBasicType type = node->getType().getBasicType();
        const glslang::TSourceLoc& loc = node->getLoc();
        const bool divides = node->getOp() == glslang::EOpDiv || node->getOp() == glslang::EOpDivAssign;
        if (divides && (type == glslang::EbtInt || type == glslang::EbtUint) && loc.string < trustedString_ &&
            found_.empty())
            found_ = "ERROR: " + std::to_string(loc.string) + ":" + std::to_string(loc.line) +
                     ": '/' : integers cannot be divided here, floats can";
        return true;
    }
    [[nodiscard]] const std::string& found() const { return found_; }

  private:
    int trustedString_;
    std::string found_;
};

}  // namespace

CompiledGlsl compileGlsl(const std::string& text, int trustedString) {
    static const bool initialized = glslang::InitializeProcess();
    CompiledGlsl result;
    if (!initialized) {
        result.log = "The compiler of shaders cannot be started.";
        return result;
    }
    constexpr auto kMessages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    glslang::TShader shader(EShLangCompute);
    const char* string = text.c_str();
    shader.setStrings(&string, 1);
    shader.setEnvInput(glslang::EShSourceGlsl, EShLangCompute, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
    if (!shader.parse(GetDefaultResources(), 450, false, kMessages)) {
        result.log = shader.getInfoLog();
        return result;
    }
    DivisionFinder divisions(trustedString);
    shader.getIntermediate()->getTreeRoot()->traverse(&divisions);
    result.log = divisions.found();
    if (!result.log.empty()) return result;
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(kMessages)) {
        result.log = program.getInfoLog();
        return result;
    }
    glslang::SpvOptions options;
    options.disableOptimizer = true;
    glslang::GlslangToSpv(*program.getIntermediate(EShLangCompute), result.code, &options);
    return result;
}

}  // namespace render
