// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/glsl_compiler.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

namespace render {

CompiledGlsl compileGlsl(const std::string& text) {
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
