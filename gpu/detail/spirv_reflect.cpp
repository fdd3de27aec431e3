// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/detail/spirv_reflect.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>

#include "gpu/detail/text.h"

namespace gpu::detail {

namespace {

// Numbers of the SPIR-V specification, sections 3.3 (capabilities are checked by the device) to 3.52.
enum Op : std::uint32_t {
    kOpName = 5,
    kOpMemberName = 6,
    kOpEntryPoint = 15,
    kOpExecutionMode = 16,
    kOpCapability = 17,
    kOpTypeBool = 20,
    kOpTypeInt = 21,
    kOpTypeFloat = 22,
    kOpTypeVector = 23,
    kOpTypeMatrix = 24,
    kOpTypeImage = 25,
    kOpTypeSampler = 26,
    kOpTypeSampledImage = 27,
    kOpTypeArray = 28,
    kOpTypeRuntimeArray = 29,
    kOpTypeStruct = 30,
    kOpTypePointer = 32,
    kOpConstant = 43,
    kOpConstantComposite = 44,
    kOpSpecConstantTrue = 48,
    kOpSpecConstantFalse = 49,
    kOpSpecConstant = 50,
    kOpSpecConstantComposite = 51,
    kOpFunction = 54,
    kOpFunctionEnd = 56,
    kOpVariable = 59,
    kOpDecorate = 71,
    kOpMemberDecorate = 72,
};
enum Decoration : std::uint32_t {
    kSpecId = 1,
    kBufferBlock = 3,
    kRowMajor = 4,
    kArrayStride = 6,
    kMatrixStride = 7,
    kBuiltIn = 11,
    kNonWritable = 24,
    kNonReadable = 25,
    kBinding = 33,
    kDescriptorSet = 34,
    kOffset = 35,
};
constexpr std::uint32_t kMagic = 0x07230203;
constexpr std::uint32_t kLocalSize = 17;
constexpr std::uint32_t kBuiltInWorkgroupSize = 25;
constexpr std::uint32_t kDim2D = 1;
enum StorageClass : std::uint32_t { kUniformConstant = 0, kUniform = 2, kPushConstant = 9, kStorageBuffer = 12 };

using Decorations = std::map<std::uint32_t, std::uint32_t>;  // decoration -> first operand, or 0

/// Parses the module into tables by id, then collects the reflection from them.
class Parser {
  public:
    Parser(std::span<const std::uint32_t> words, const std::string& label) : words_(words), label_(label) {}

    Reflection run() {
        readTables();
        requireModule(entryPoints_ == 1, "has ", entryPoints_, " entry points; one is expected");
        for (const auto& [id, type] : types_) {
            if (type.op == kOpTypeStruct && members_[id][0].contains(kOffset)) {
                result_.structs.push_back(layoutOf(id, type));
            }
        }
        for (const Variable& variable : variables_) reflectVariable(variable);
        std::sort(result_.bindings.begin(), result_.bindings.end(),
                  [](const auto& a, const auto& b) { return std::tie(a.set, a.binding) < std::tie(b.set, b.binding); });
        for (std::size_t i = 1; i < result_.bindings.size(); ++i) {
            const ReflectedBinding& a = result_.bindings[i - 1];
            const ReflectedBinding& b = result_.bindings[i];
            requireModule(a.set != b.set || a.binding != b.binding, "declares set ", b.set, " binding ", b.binding,
                          " twice (", a.name, ", ", b.name, ")");
        }
        reflectConstants();
        return std::move(result_);
    }

  private:
    struct Type {
        std::uint32_t op = 0;
        std::vector<std::uint32_t> operands;  // after the result id
    };
    struct Constant {
        std::uint32_t op = 0;
        std::uint32_t type = 0;
        std::vector<std::uint32_t> operands;
    };
    struct Variable {
        std::uint32_t id = 0;
        std::uint32_t type = 0;
        std::uint32_t storageClass = 0;
    };

    template <class... Args>
    void requireModule(bool condition, const Args&... message) const {
        require(condition, "Shader module ", quoted(label_), " ", text(message...), ".");
    }

    static std::string literal(std::span<const std::uint32_t> words) {
        std::string result;
        for (const std::uint32_t word : words) {
            for (int i = 0; i < 4; ++i) {
                const char c = static_cast<char>((word >> (8 * i)) & 0xffu);
                if (c == 0) return result;
                result += c;
            }
        }
        return result;
    }

    void readTables() {
        requireModule(words_.size() >= 5 && words_[0] == kMagic, "is not SPIR-V: ", words_.size(),
                      " words without the magic number 0x07230203 in front");
        std::size_t at = 5;
        while (at < words_.size()) {
            const std::uint32_t op = words_[at] & 0xffffu;
            const std::size_t count = words_[at] >> 16;
            requireModule(count != 0 && at + count <= words_.size(), "is damaged: the instruction at word ", at,
                          " has ", count, " words, ", words_.size() - at, " are left");
            readInstruction(op, words_.subspan(at + 1, count - 1));
            at += count;
        }
        requireModule(!insideFunction_, "is damaged: it ends inside a function");
    }

    void needs(std::span<const std::uint32_t> operands, std::size_t count) const {
        requireModule(operands.size() >= count, "is damaged: an instruction has ", operands.size(), " operands, ",
                      count, " are needed");
    }

    using Operands = std::span<const std::uint32_t>;

    /// How an instruction is read; those without a row are skipped.
    struct Instruction {
        Op op;
        std::size_t minOperands;
        void (Parser::*read)(Op op, Operands w);
    };

    void readInstruction(std::uint32_t op, Operands w) {
        static constexpr Instruction kInstructions[] = {
            {kOpName, 2, &Parser::readName},
            {kOpMemberName, 3, &Parser::readMemberName},
            {kOpEntryPoint, 3, &Parser::readEntryPoint},
            {kOpExecutionMode, 2, &Parser::readExecutionMode},
            {kOpCapability, 1, &Parser::readCapability},
            {kOpTypeBool, 1, &Parser::readType},
            {kOpTypeInt, 2, &Parser::readType},
            {kOpTypeFloat, 2, &Parser::readType},
            {kOpTypeVector, 2, &Parser::readType},
            {kOpTypeMatrix, 2, &Parser::readType},
            {kOpTypeImage, 8, &Parser::readType},
            {kOpTypeSampler, 1, &Parser::readType},
            {kOpTypeSampledImage, 2, &Parser::readType},
            {kOpTypeArray, 2, &Parser::readType},
            {kOpTypeRuntimeArray, 2, &Parser::readType},
            {kOpTypeStruct, 1, &Parser::readType},
            {kOpTypePointer, 2, &Parser::readType},
            {kOpConstant, 2, &Parser::readConstant},
            {kOpConstantComposite, 2, &Parser::readConstant},
            {kOpSpecConstantTrue, 2, &Parser::readConstant},
            {kOpSpecConstantFalse, 2, &Parser::readConstant},
            {kOpSpecConstant, 2, &Parser::readConstant},
            {kOpSpecConstantComposite, 2, &Parser::readConstant},
            {kOpFunction, 0, &Parser::readFunction},
            {kOpFunctionEnd, 0, &Parser::readFunctionEnd},
            {kOpVariable, 3, &Parser::readVariable},
            {kOpDecorate, 2, &Parser::readDecoration},
            {kOpMemberDecorate, 3, &Parser::readMemberDecoration},
        };
        const auto row = std::ranges::find(kInstructions, op, &Instruction::op);
        if (row == std::end(kInstructions)) return;
        needs(w, row->minOperands);
        (this->*row->read)(row->op, w);
    }

    void readName(Op, Operands w) { names_[w[0]] = literal(w.subspan(1)); }
    void readMemberName(Op, Operands w) { memberNames_[{w[0], w[1]}] = literal(w.subspan(2)); }
    void readCapability(Op, Operands w) { result_.capabilities.push_back(w[0]); }
    void readType(Op op, Operands w) { types_[w[0]] = {op, {w.begin() + 1, w.end()}}; }
    void readConstant(Op op, Operands w) { constants_[w[1]] = {op, w[0], {w.begin() + 2, w.end()}}; }
    void readVariable(Op, Operands w) { variables_.push_back({w[1], w[0], w[2]}); }
    void readDecoration(Op, Operands w) { decorations_[w[0]][w[1]] = w.size() > 2 ? w[2] : 0; }
    void readMemberDecoration(Op, Operands w) { members_[w[0]][w[1]][w[2]] = w.size() > 3 ? w[3] : 0; }
    void readFunctionEnd(Op, Operands) { insideFunction_ = false; }

    void readFunction(Op, Operands) {
        requireModule(!insideFunction_, "is damaged: a function begins inside another");
        insideFunction_ = true;
    }

    void readExecutionMode(Op, Operands w) {
        if (w[1] != kLocalSize) return;
        needs(w, 5);
        result_.workgroupSize = {w[2], w[3], w[4]};
    }

    void readEntryPoint(Op, Operands w) {
        const std::uint32_t model = w[0];
        const std::string name = literal(w.subspan(2));
        ++entryPoints_;
        requireModule(model == 0 || model == 4 || model == 5, "has execution model ", model,
                      "; vertex, fragment or compute is expected");
        result_.stage = model == 0 ? ShaderStage::Vertex : model == 4 ? ShaderStage::Fragment : ShaderStage::Compute;
        requireModule(name == "main", "has the entry point \"", name, "\"; \"main\" is expected");
    }

    const Type& typeOf(std::uint32_t id) const {
        const auto found = types_.find(id);
        requireModule(found != types_.end(), "is damaged: type %", id, " is not declared");
        return found->second;
    }

    std::uint32_t constantValue(std::uint32_t id) const {
        const auto found = constants_.find(id);
        requireModule(found != constants_.end() && !found->second.operands.empty(), "is damaged: constant %", id,
                      " has no value");
        return found->second.operands[0];
    }

    /// Bytes without trailing padding; 0 for an array without a length.
    std::uint32_t sizeOf(std::uint32_t id, const Decorations& member, int depth = 0) {
        requireModule(depth < 32, "is damaged: types are nested too deeply");
        const Type& type = typeOf(id);
        switch (type.op) {
            case kOpTypeInt:
            case kOpTypeFloat:
                return type.operands[0] / 8;
            case kOpTypeVector:
                return type.operands.at(1) * sizeOf(type.operands[0], {}, depth + 1);
            case kOpTypeMatrix: {
                const auto stride = member.find(kMatrixStride);
                requireModule(stride != member.end(), "has a matrix without a stride in a block");
                const std::uint32_t columns = type.operands.at(1);
                const std::uint32_t rows = typeOf(type.operands[0]).operands.at(1);
                return stride->second * (member.contains(kRowMajor) ? rows : columns);
            }
            case kOpTypeArray:
                return decorations_[id][kArrayStride] * constantValue(type.operands.at(1));
            case kOpTypeRuntimeArray:
                return 0;
            case kOpTypeStruct: {
                std::uint32_t end = 0;
                for (std::uint32_t i = 0; i < type.operands.size(); ++i) {
                    const Decorations& decorations = members_[id][i];
                    const auto offset = decorations.find(kOffset);
                    if (offset == decorations.end()) continue;
                    end = std::max(end, offset->second + sizeOf(type.operands[i], decorations, depth + 1));
                }
                return end;
            }
            default:
                return 0;
        }
    }

    BlockLayout layoutOf(std::uint32_t id, const Type& type) {
        BlockLayout layout{.name = names_[id], .size = sizeOf(id, {}), .members = {}};
        for (std::uint32_t i = 0; i < type.operands.size(); ++i) {
            const Decorations& decorations = members_[id][i];
            const auto offset = decorations.find(kOffset);
            if (offset == decorations.end()) continue;
            layout.members.push_back({memberNames_[{id, i}], offset->second, sizeOf(type.operands[i], decorations)});
        }
        return layout;
    }

    /// Minimum bytes of a binding: up to its last member, counting one element of an array without a length.
    std::uint64_t minBindingSize(std::uint32_t id) {
        const Type& type = typeOf(id);
        std::uint64_t size = sizeOf(id, {});
        if (type.op == kOpTypeStruct && !type.operands.empty()) {
            const std::uint32_t last = type.operands.back();
            if (typeOf(last).op == kOpTypeRuntimeArray) {
                const auto index = static_cast<std::uint32_t>(type.operands.size() - 1);
                size = std::max<std::uint64_t>(
                    size, std::uint64_t{members_[id][index][kOffset]} + decorations_[last][kArrayStride]);
            }
        }
        return size;
    }

    /// True if the variable, or every member of its block, has a decoration (glslang writes `readonly buffer` that
    /// way).
    bool decorated(std::uint32_t variable, std::uint32_t typeId, std::uint32_t decoration) {
        if (decorations_[variable].contains(decoration)) return true;
        const Type& type = typeOf(typeId);
        if (type.op != kOpTypeStruct || type.operands.empty()) return false;
        for (std::uint32_t i = 0; i < type.operands.size(); ++i) {
            if (!members_[typeId][i].contains(decoration)) return false;
        }
        return true;
    }

    void reflectVariable(const Variable& variable) {
        if (variable.storageClass != kUniformConstant && variable.storageClass != kUniform &&
            variable.storageClass != kPushConstant && variable.storageClass != kStorageBuffer) {
            return;
        }
        const Type& pointer = typeOf(variable.type);
        requireModule(pointer.op == kOpTypePointer && pointer.operands.size() >= 2,
                      "is damaged: a variable's type is not a pointer");
        const std::uint32_t typeId = pointer.operands[1];
        const Type& type = typeOf(typeId);
        if (variable.storageClass == kPushConstant) {
            result_.immediateSize = std::max(result_.immediateSize, sizeOf(typeId, {}));
            return;
        }
        const Decorations& decorations = decorations_[variable.id];
        std::string name = names_[variable.id];
        if (name.empty()) name = names_[typeId];
        requireModule(decorations.contains(kDescriptorSet) && decorations.contains(kBinding), "declares \"", name,
                      "\" without set and binding");
        ReflectedBinding binding;
        binding.set = decorations.at(kDescriptorSet);
        binding.binding = decorations.at(kBinding);
        binding.name = name;
        requireModule(type.op != kOpTypeArray && type.op != kOpTypeRuntimeArray, "declares an array of resources (\"",
                      name, "\"); one resource per binding is expected");
        if (type.op == kOpTypeStruct) {
            const bool storage = variable.storageClass == kStorageBuffer || decorations_[typeId].contains(kBufferBlock);
            binding.type = !storage                                       ? BindingType::UniformBuffer
                           : decorated(variable.id, typeId, kNonWritable) ? BindingType::ReadOnlyStorageBuffer
                                                                          : BindingType::StorageBuffer;
            binding.minBindingSize = minBindingSize(typeId);
        } else if (type.op == kOpTypeSampler) {
            binding.type = BindingType::Sampler;
        } else if (type.op == kOpTypeSampledImage) {
            reflectImage(typeOf(type.operands[0]), variable.id, binding);
            binding.type = BindingType::CombinedTextureSampler;
        } else {
            requireModule(type.op == kOpTypeImage, "declares \"", name, "\", a kind of resource that is not supported");
            reflectImage(type, variable.id, binding);
        }
        result_.bindings.push_back(std::move(binding));
    }

    void reflectImage(const Type& image, std::uint32_t variable, ReflectedBinding& binding) {
        requireModule(image.op == kOpTypeImage && image.operands.size() >= 7,
                      "is damaged: an image type is incomplete");
        const auto& o = image.operands;  // sampled type, dim, depth, arrayed, multisampled, sampled, format
        requireModule(o[1] == kDim2D && o[3] == 0 && o[4] == 0, "declares \"", binding.name,
                      "\", which is not a plain two-dimensional image");
        const Type& sampled = typeOf(o[0]);
        binding.sampleType = sampled.op == kOpTypeFloat    ? TextureSampleType::Float
                             : sampled.operands.at(1) == 0 ? TextureSampleType::Uint
                                                           : TextureSampleType::Sint;
        if (o[5] == 1) {
            binding.type = BindingType::SampledTexture;
            return;
        }
        const bool noWrites = decorations_[variable].contains(kNonWritable);
        const bool noReads = decorations_[variable].contains(kNonReadable);
        binding.type = noWrites  ? BindingType::ReadOnlyStorageTexture
                       : noReads ? BindingType::WriteOnlyStorageTexture
                                 : BindingType::ReadWriteStorageTexture;
        static const std::map<std::uint32_t, TextureFormat> kFormats = {
            {1, TextureFormat::RGBA32Float}, {2, TextureFormat::RGBA16Float}, {3, TextureFormat::R32Float},
            {4, TextureFormat::RGBA8Unorm},  {6, TextureFormat::RG32Float},   {9, TextureFormat::R16Float},
            {15, TextureFormat::R8Unorm},    {30, TextureFormat::RGBA32Uint}, {33, TextureFormat::R32Uint}};
        const auto format = kFormats.find(o[6]);
        requireModule(format != kFormats.end(), "declares the storage image \"", binding.name,
                      "\" with SPIR-V image format ", o[6], ", which no texture can have");
        binding.storageFormat = format->second;
    }

    void reflectConstants() {
        std::map<std::uint32_t, std::uint32_t> idOf;  // result id -> constant_id
        for (const auto& [id, constant] : constants_) {
            const auto decorations = decorations_.find(id);
            if (decorations == decorations_.end()) continue;
            const auto specId = decorations->second.find(kSpecId);
            if (specId != decorations->second.end()) {
                ReflectedConstant reflected{.id = specId->second, .name = names_[id], .kind = ConstantKind::Bool};
                if (constant.op == kOpSpecConstant) {
                    const Type& type = typeOf(constant.type);
                    requireModule(type.operands.at(0) == 32, "has the specialization constant \"", reflected.name,
                                  "\" of ", type.operands[0], " bits; 32 are expected");
                    reflected.kind = type.op == kOpTypeFloat    ? ConstantKind::Float
                                     : type.operands.at(1) == 0 ? ConstantKind::Uint
                                                                : ConstantKind::Int;
                }
                idOf[id] = reflected.id;
                result_.constants.push_back(std::move(reflected));
            }
        }
        for (const auto& [id, constant] : constants_) {
            const auto decorations = decorations_.find(id);
            if (decorations == decorations_.end()) continue;
            const auto builtIn = decorations->second.find(kBuiltIn);
            if (builtIn == decorations->second.end() || builtIn->second != kBuiltInWorkgroupSize) continue;
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t part = constant.operands.at(i);
                result_.workgroupSize[i] = constantValue(part);
                if (idOf.contains(part)) result_.workgroupSizeConstants[i] = idOf[part];
            }
        }
    }

    std::span<const std::uint32_t> words_;
    const std::string& label_;
    Reflection result_;
    std::uint32_t entryPoints_ = 0;
    bool insideFunction_ = false;
    std::unordered_map<std::uint32_t, std::string> names_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> memberNames_;
    std::map<std::uint32_t, Type> types_;
    std::map<std::uint32_t, Constant> constants_;
    std::map<std::uint32_t, Decorations> decorations_;
    std::map<std::uint32_t, std::map<std::uint32_t, Decorations>> members_;
    std::vector<Variable> variables_;
};

}  // namespace

Reflection reflectSpirv(std::span<const std::uint32_t> words, const std::string& label) {
    try {
        return Parser(words, label).run();
    } catch (const std::out_of_range&) {
        throw Error(ErrorKind::Validation, text("Shader module ", quoted(label), " is damaged."));
    }
}

}  // namespace gpu::detail
