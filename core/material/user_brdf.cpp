// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/user_brdf.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <set>

#include "core/base/files.h"
#include "core/material/glsl_tokens.h"
#include "core/material/user_brdf_params.h"

namespace core {

namespace {

using Names = std::set<std::string, std::less<>>;

const Names kTypes{"void",  "bool",  "int",   "uint",  "float", "vec2",  "vec3",  "vec4", "ivec2", "ivec3",
                   "ivec4", "uvec2", "uvec3", "uvec4", "bvec2", "bvec3", "bvec4", "mat2", "mat3",  "mat4"};

/// Words of GLSL that stay unchanged.
const Names kWords{"if",    "else", "for", "while", "do",   "return", "break", "continue",
                   "const", "in",   "out", "inout", "true", "false",  "length"};

/// Functions of GLSL that stay unchanged.
const Names kBuiltins{"radians",
                      "degrees",
                      "sin",
                      "cos",
                      "tan",
                      "asin",
                      "acos",
                      "atan",
                      "sinh",
                      "cosh",
                      "tanh",
                      "asinh",
                      "acosh",
                      "atanh",
                      "pow",
                      "exp",
                      "log",
                      "exp2",
                      "log2",
                      "sqrt",
                      "inversesqrt",
                      "abs",
                      "sign",
                      "floor",
                      "trunc",
                      "round",
                      "roundEven",
                      "ceil",
                      "fract",
                      "mod",
                      "min",
                      "max",
                      "clamp",
                      "mix",
                      "step",
                      "smoothstep",
                      "isnan",
                      "isinf",
                      "fma",
                      "distance",
                      "dot",
                      "cross",
                      "normalize",
                      "faceforward",
                      "reflect",
                      "refract",
                      "lessThan",
                      "lessThanEqual",
                      "greaterThan",
                      "greaterThanEqual",
                      "equal",
                      "notEqual",
                      "any",
                      "all",
                      "not",
                      "transpose",
                      "determinant",
                      "inverse",
                      "outerProduct",
                      "matrixCompMult",
                      "floatBitsToInt",
                      "floatBitsToUint",
                      "intBitsToFloat",
                      "uintBitsToFloat"};

/// Names offered in addition to GLSL, and their names in the program.
const std::map<std::string, std::string, std::less<>> kOffered{{"kPi", "kPi"},
                                                               {"kInvPi", "kInvPi"},
                                                               {"luminance", "luminance"},
                                                               {"sample_cosine_hemisphere", "sample_cosine_hemisphere"},
                                                               {"turn_frame", "turn_frame"},
                                                               {"fresnel", "user_fresnel"},
                                                               {"fresnel_dielectric", "fresnel_dielectric"},
                                                               {"fresnel_conductor", "fresnel_conductor"},
                                                               {"ggx_lobe", "ggx_lobe"},
                                                               {"ggx_lobe_pdf", "ggx_lobe_pdf"},
                                                               {"ggx_lobe_sample", "ggx_lobe_sample"}};
/// Cost of calling one of them, in tokens.
constexpr std::size_t kOfferedSize = 100;

/// Words that would let a text reach beyond its own functions, or run without bound.
const Names kRefused{"layout",    "buffer",   "shared",     "attribute",     "varying",   "coherent",
                     "volatile",  "restrict", "subroutine", "struct",        "precision", "precise",
                     "invariant", "discard",  "switch",     "case",          "default",   "goto",
                     "uniform",   "double",   "sampler2D",  "memoryBarrier", "barrier"};

struct Signature {
    const char* name;
    const char* result;
    const char* first;
    const char* second;
    int UserBrdf::*line;
};
constexpr Signature kNeeded[] = {{"evaluate", "vec3", "vec3 wo", "vec3 wi", &UserBrdf::evaluateLine},
                                 {"pdf", "float", "vec3 wo", "vec3 wi", &UserBrdf::pdfLine},
                                 {"sample", "vec3", "vec3 wo", "vec2 u", &UserBrdf::sampleLine}};

struct Function {
    int line = 0;
    std::size_t tokens = 0;
    std::vector<std::string> calls;
};

bool isSwizzle(std::string_view name) {
    for (const std::string_view set : {"xyzw", "rgba", "stpq"})
        if (name.size() <= 4 && name.find_first_not_of(set) == std::string_view::npos) return true;
    return false;
}

/// FNV-1a.
std::uint32_t hashOf(std::string_view text) {
    std::uint32_t hash = 2166136261U;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    return hash;
}

class Reader {
  public:
    Reader(UserBrdf& brdf, GlslText text) : brdf_(brdf), text_(std::move(text)) {}

    void read() {
        readGlobals();
        requireNeeded();
        std::map<std::string, std::size_t> sizes;
        Names open;
        for (const auto& [name, function] : functions_) static_cast<void>(expandedSize(name, sizes, open));
        before_.resize(kept_.size());
        after_.resize(kept_.size());
        boundLoops();
        boundIndices();
        write();
    }

  private:
    [[noreturn]] void refuse(int line, const Message& reason) const { refuseGlsl(brdf_.path, line, reason); }

    static bool isFixed(std::string_view name) {
        return kTypes.contains(name) || kWords.contains(name) || kBuiltins.contains(name) || kOffered.contains(name);
    }

    /// Declarations outside functions: removes parameters, keeps constants and functions.
    void readGlobals() {
        const std::vector<GlslToken>& tokens = text_.tokens;
        for (const GlslToken& t : tokens)
            if (t.isName() && t.text != "uniform" && kRefused.contains(t.text))
                refuse(t.line, Message("messages", "\"%1\" is not allowed here.").with(t.text));
        std::size_t i = 0;
        while (i < tokens.size()) {
            if (tokens[i].is(";")) {
                ++i;
            } else if (tokens[i].is("uniform")) {
                i = readParam(i);
            } else {
                i = readGlobal(i);
            }
        }
    }

    std::size_t readParam(std::size_t i) {
        const std::size_t end = readUserParam(text_, i, brdf_.path, brdf_);
        const GlslToken& name = text_.tokens[i + 2];
        if (isFixed(name.text))
            refuse(name.line, Message("messages", "\"%1\" is a name of GLSL or of the program.").with(name.text));
        return end;
    }

    /// `const TYPE name ...;`, `TYPE name(...) {...}` or `TYPE name(...);` at token `i`; returns the next token.
    std::size_t readGlobal(std::size_t i) {
        const std::vector<GlslToken>& tokens = text_.tokens;
        const bool constant = tokens[i].is("const");
        const std::size_t type = i + (constant ? 1 : 0);
        const std::size_t name = type + 1;
        if (name >= tokens.size() || !kTypes.contains(tokens[type].text) || !tokens[name].isName())
            refuse(tokens[i].line, Message("messages",
                                           "Expected a function, a constant (const float a = 1.0;) or a parameter "
                                           "(uniform float a = 0.5;  // 0 to 1), found \"%1\".")
                                       .with(tokens[i].text));
        if (isFixed(tokens[name].text))
            refuse(tokens[name].line,
                   Message("messages", "\"%1\" is a name of GLSL or of the program.").with(tokens[name].text));
        const bool function = name + 1 < tokens.size() && tokens[name + 1].is("(");
        if (!function && !constant)
            refuse(tokens[i].line, Message("messages", "Variables outside functions have to be const."));
        std::size_t end = i;
        while (end < tokens.size() && !tokens[end].is(";") && !(function && tokens[end].is("{"))) ++end;
        if (end == tokens.size()) refuse(tokens[i].line, Message("messages", "This declaration does not end."));
        if (tokens[end].is("{")) {
            checkSignature(type, name);
            end = readBody(tokens[name], end);
        }
        if (!function) refuseTakenNames(i, end);
        for (; i <= end; ++i) kept_.push_back(tokens[i]);
        return end + 1;
    }

    void checkSignature(std::size_t type, std::size_t name) {
        const std::vector<GlslToken>& tokens = text_.tokens;
        for (const Signature& s : kNeeded) {
            if (!tokens[name].is(s.name)) continue;
            const auto is = [&](std::size_t n, const char* parameter) {
                return std::string_view(parameter).starts_with(tokens[n].text + " ");
            };
            if (name + 7 >= tokens.size() || !tokens[type].is(s.result) || !is(name + 2, s.first) ||
                !is(name + 5, s.second) || !tokens[name + 4].is(",") || !tokens[name + 7].is(")"))
                refuse(tokens[name].line, Message("messages", "This function has to be %1.").with(written(s)));
            brdf_.*s.line = tokens[name].line;
        }
    }

    static std::string written(const Signature& s) {
        return std::string(s.result) + " " + s.name + "(" + s.first + ", " + s.second + ")";
    }

    /// Reads the body that begins at token `i`; returns its closing brace.
    std::size_t readBody(const GlslToken& name, std::size_t i) {
        const std::vector<GlslToken>& tokens = text_.tokens;
        Function& function = functions_[name.text];
        function.line = name.line;
        int depth = 0;
        for (;; ++i) {
            if (tokens[i].is("{")) ++depth;
            if (tokens[i].is("}") && --depth == 0) return i;
            if (tokens[i].is("uniform"))
                refuse(tokens[i].line, Message("messages", "Parameters are declared outside functions."));
            ++function.tokens;
            if (i + 1 < tokens.size() && tokens[i].isName() && tokens[i + 1].is("("))
                function.calls.push_back(tokens[i].text);
        }
    }

    /// Checks the names of further constants in a declaration, after the first.
    void refuseTakenNames(std::size_t i, std::size_t end) const {
        for (int depth = 0; i < end; ++i) {
            const GlslToken& t = text_.tokens[i];
            if (t.is("(") || t.is("[")) ++depth;
            if (t.is(")") || t.is("]")) --depth;
            const GlslToken& next = text_.tokens[i + 1];
            if (depth == 0 && t.is(",") && isFixed(next.text))
                refuse(next.line, Message("messages", "\"%1\" is a name of GLSL or of the program.").with(next.text));
        }
    }

    void requireNeeded() const {
        for (const Signature& s : kNeeded)
            if (!functions_.contains(s.name))
                refuse(1, Message("messages", "The file lacks the function %1.").with(written(s)));
    }

    std::size_t expandedSize(const std::string& name, std::map<std::string, std::size_t>& known, Names& open) const {
        if (const auto found = known.find(name); found != known.end()) return found->second;
        const Function& f = functions_.at(name);
        if (!open.insert(name).second)
            refuse(f.line, Message("messages", "\"%1\" calls itself; GLSL has no recursion.").with(name));
        std::size_t size = f.tokens;
        for (const std::string& callee : f.calls) {
            if (functions_.contains(callee)) size += expandedSize(callee, known, open);
            if (kOffered.contains(callee)) size += kOfferedSize;
            if (size > kMaxUserBrdfExpanded)
                refuse(f.line,
                       Message("messages", "\"%1\" is too long with all that it calls: more than %2 words and signs.")
                           .with(name, kMaxUserBrdfExpanded));
        }
        open.erase(name);
        return known[name] = size;
    }

    /// The bracket that closes the one at token `i`.
    [[nodiscard]] std::size_t closing(std::size_t i) const {
        int depth = 0;
        for (;; ++i) {
            if (kept_[i].is("(") || kept_[i].is("[") || kept_[i].is("{")) ++depth;
            if ((kept_[i].is(")") || kept_[i].is("]") || kept_[i].is("}")) && --depth == 0) return i;
        }
    }

    /// Makes every loop call user_step() before it continues.
    void boundLoops() {
        for (std::size_t i = 0; i + 1 < kept_.size(); ++i) {
            const bool isFor = kept_[i].is("for");
            if (!isFor && !kept_[i].is("while")) continue;
            if (!kept_[i + 1].is("("))
                refuse(kept_[i].line, Message("messages", "\"%1\" needs a condition in ( ).").with(kept_[i].text));
            const std::size_t end = closing(i + 1);
            std::size_t first = i + 2;
            std::size_t last = end;
            if (isFor) {
                std::vector<std::size_t> semicolons;
                for (std::size_t j = first; j < end; ++j)
                    if (kept_[j].is(";")) semicolons.push_back(j);
                if (semicolons.size() != 2)
                    refuse(kept_[i].line, Message("messages", "\"for\" needs (start; condition; step)."));
                first = semicolons[0] + 1;
                last = semicolons[1];
            }
            if (first == last) {
                before_[last] += "user_step() ";
            } else {
                before_[first] = "user_step() && (" + before_[first];
                before_[last] = ") " + before_[last];
            }
        }
    }

    /// Limits the size of arrays and bounds indices: [N] stays, a[i] becomes a[user_index(i, a.length())].
    void boundIndices() {
        int sum = 0;
        for (std::size_t i = 0; i < kept_.size(); ++i) {
            if (!kept_[i].is("[")) continue;
            const int line = kept_[i].line;
            const std::size_t end = closing(i);
            if (i < 2 || !kept_[i - 1].isName() || kept_[i - 2].is("."))
                refuse(line, Message("messages", "Only a name can be indexed here."));
            if (kTypes.contains(kept_[i - 1].text) && (end + 1 == kept_.size() || !kept_[end + 1].is("(")))
                refuse(line, Message("messages", "An array is declared as float a[3], without arrays in it."));
            if (end == i + 1) continue;
            if (end == i + 2 && kept_[i + 1].kind == GlslToken::Kind::Number) {
                const std::string& text = kept_[i + 1].text;
                int size = -1;
                const auto [last, code] = std::from_chars(text.data(), text.data() + text.size(), size);
                const bool whole =
                    code == std::errc() && last == text.data() + text.size() && (text == "0" || text[0] != '0');
                if (!whole || size > kMaxUserBrdfElements)
                    refuse(line,
                           Message("messages", "\"%1\" is too large for an array, or no number; expected at most %2.")
                               .with(text, kMaxUserBrdfElements));
                if ((sum += size) > kMaxUserBrdfElementSum)
                    refuse(line, Message("messages", "There are too many large arrays."));
                continue;
            }
            const std::string name = renamed(kept_[i - 1].text);
            if (isFixed(kept_[i - 1].text) || kTypes.contains(kept_[i - 2].text))
                refuse(line, Message("messages", "The size of an array has to be a number."));
            after_[i] += "user_index(";
            before_[end] += ", " + name + ".length()) ";
        }
    }

    [[nodiscard]] static std::string renamed(const std::string& name) {
        if (const auto offered = kOffered.find(name); offered != kOffered.end()) return offered->second;
        return isFixed(name) ? name : std::string(kUserBrdfPrefix) + name;
    }

    void write() {
        int line = 1;
        for (std::size_t i = 0; i < kept_.size(); ++i) {
            const GlslToken& t = kept_[i];
            for (; line < t.line; ++line) brdf_.code += '\n';
            const bool member = i > 0 && kept_[i - 1].is(".");
            if (member && !isSwizzle(t.text) && !t.is("length"))
                refuse(t.line, Message("messages", "There is no field \"%1\".").with(t.text));
            brdf_.code += before_[i] + (t.isName() && !member ? renamed(t.text) : t.text) + " " + after_[i];
            if (t.is("fresnel") && !member) {
                if (!brdf_.usesSpecular)
                    refuse(t.line, Message("messages", "fresnel(cosine) needs uniform vec3 specular;"));
                brdf_.usesFresnel = true;
            }
        }
        brdf_.code += '\n';
    }

    UserBrdf& brdf_;
    GlslText text_;
    std::vector<GlslToken> kept_;
    std::vector<std::string> before_, after_;  ///< text inserted around each token of `kept_`
    std::map<std::string, Function> functions_;
};

}  // namespace

std::shared_ptr<const UserBrdf> parseUserBrdf(const std::string& path, std::string_view text) {
    auto brdf = std::make_shared<UserBrdf>();
    brdf->path = path;
    brdf->revision = hashOf(text);
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    Reader(*brdf, tokenizeGlsl(path, text)).read();
    return brdf;
}

std::shared_ptr<const UserBrdf> loadUserBrdf(const std::string& path) {
    return parseUserBrdf(path, readFile(path, kMaxUserBrdfBytes));
}

}  // namespace core
