#include "gpu/embed/gpu_arithmetic.hpp"

#include <map>
#include <string_view>
#include <utility>

namespace glint::gpu {
namespace {

// SPIR-V 1.6, section 3; its instruction set GLSL.std.450.
constexpr uint32_t kMagic = 0x07230203;
constexpr size_t kHeaderWords = 5;
constexpr size_t kBoundWord = 3;

enum Opcode : uint32_t {
    kExtInstImport = 11,
    kExtInst = 12,
    kTypeFloat = 22,
    kTypeVector = 23,
    kConstant = 43,
    kConstantComposite = 44,
    kFunction = 54,
    kFAdd = 129,
    kFSub = 131,
    kFMul = 133,
    kFDiv = 136,
};
constexpr uint32_t kFMix = 46;

using Words = std::vector<uint32_t>;

/// One instruction; operands count from the word behind the opcode's.
struct Instruction {
    uint32_t opcode;
    std::span<const uint32_t> operands;
    std::span<const uint32_t> words;
};

class Rewriter {
public:
    explicit Rewriter(std::span<const uint32_t> words) : words_(words), bound_(words[kBoundWord]) {}

    Result<Words> run() {
        GLINT_CHECK(forEach([&](const Instruction& instruction) { learn(instruction); }));
        Words body;
        Words head(words_.begin(), words_.begin() + kHeaderWords);
        bool inFunctions = false;
        GLINT_CHECK(forEach([&](const Instruction& instruction) {
            inFunctions = inFunctions || instruction.opcode == kFunction;
            Words& target = inFunctions ? body : head;
            if (!inFunctions || !rewrite(instruction, target))
                target.insert(target.end(), instruction.words.begin(), instruction.words.end());
        }));
        head.insert(head.end(), declarations_.begin(), declarations_.end());
        head.insert(head.end(), body.begin(), body.end());
        head[kBoundWord] = bound_;
        return head;
    }

private:
    template <class Visit>
    Result<void> forEach(const Visit& visit) const {
        for (size_t at = kHeaderWords; at < words_.size();) {
            const uint32_t count = words_[at] >> 16;
            if (count == 0 || count > words_.size() - at)
                return invalidArgument("not SPIR-V: an instruction of {} words at word {}", count, at);
            const auto words = words_.subspan(at, count);
            visit(Instruction{words_[at] & 0xffffU, words.subspan(1), words});
            at += count;
        }
        return {};
    }

    void learn(const Instruction& instruction) {
        const auto& operands = instruction.operands;
        switch (instruction.opcode) {
        case kExtInstImport:
            if (operands.size() > 1 && std::string_view(reinterpret_cast<const char*>(&operands[1])) == "GLSL.std.450")
                instructionSet_ = operands[0];
            break;
        case kTypeFloat:
            if (operands.size() == 2 && operands[1] == 32)
                float_ = operands[0];
            break;
        case kTypeVector: vectors_[operands[0]] = {operands[1], operands[2]}; break;
        default: break;
        }
    }

    /// Writes what replaces the instruction; false if it stays as it is.
    bool rewrite(const Instruction& instruction, Words& out) {
        const auto& operands = instruction.operands;
        switch (instruction.opcode) {
        case kFDiv: return divide(operands, out);
        case kExtInst:
            if (operands[2] != instructionSet_ || operands[3] != kFMix)
                return false;
            mix(operands, out);
            return true;
        default: return false;
        }
    }

    void mix(std::span<const uint32_t> operands, Words& out) {
        const uint32_t type = operands[0];
        const uint32_t x = operands[4];
        const uint32_t apart = emit(kFSub, type, {operands[5], x}, out);
        const uint32_t part = emit(kFMul, type, {operands[6], apart}, out);
        emitAs(operands[1], kFAdd, type, {x, part}, out);
    }

    bool divide(std::span<const uint32_t> operands, Words& out) {
        const uint32_t type = operands[0];
        const uint32_t one = oneOf(type);
        if (one == 0)
            return false;
        const uint32_t inverse = emit(kFDiv, type, {one, operands[3]}, out);
        emitAs(operands[1], kFMul, type, {operands[2], inverse}, out);
        return true;
    }

    uint32_t emit(Opcode opcode, uint32_t type, std::initializer_list<uint32_t> operands, Words& out) {
        const uint32_t result = bound_++;
        emitAs(result, opcode, type, operands, out);
        return result;
    }
    static void emitAs(uint32_t result, Opcode opcode, uint32_t type, std::initializer_list<uint32_t> operands,
                       Words& out) {
        out.push_back(static_cast<uint32_t>(operands.size() + 3) << 16 | opcode);
        out.push_back(type);
        out.push_back(result);
        out.insert(out.end(), operands);
    }

    /// The constant 1 of a type of floats of 32 bits, which is declared for it; 0 for another type.
    uint32_t oneOf(uint32_t type) {
        constexpr uint32_t kOne = 0x3f800000;
        const auto vector = vectors_.find(type);
        const bool isVector = vector != vectors_.end() && vector->second.first == float_;
        if (type != float_ && !isVector)
            return 0;
        if (const auto known = ones_.find(type); known != ones_.end())
            return known->second;
        uint32_t id = 0;
        if (isVector) {
            const uint32_t scalar = oneOf(float_);
            id = bound_++;
            declarations_.push_back((3 + vector->second.second) << 16 | kConstantComposite);
            declarations_.push_back(type);
            declarations_.push_back(id);
            declarations_.insert(declarations_.end(), vector->second.second, scalar);
        } else {
            id = emit(kConstant, type, {kOne}, declarations_);
        }
        ones_[type] = id;
        return id;
    }

    std::span<const uint32_t> words_;
    uint32_t bound_; ///< the next free id
    Words declarations_;
    uint32_t instructionSet_ = 0;
    uint32_t float_ = 0;
    std::map<uint32_t, std::pair<uint32_t, uint32_t>> vectors_; ///< id: component type, count
    std::map<uint32_t, uint32_t> ones_;                         ///< by type
};

} // namespace

Result<Words> asGpusCompute(std::span<const uint32_t> words) {
    if (words.size() < kHeaderWords || words[0] != kMagic)
        return invalidArgument("not SPIR-V");
    return Rewriter(words).run();
}

} // namespace glint::gpu
