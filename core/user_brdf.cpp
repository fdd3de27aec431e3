// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/user_brdf.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "core/error.h"

namespace core {

namespace {

struct Token {
    std::string text;
    int line = 1;
    bool name = false;
};

class Refusal {
  public:
    explicit Refusal(std::string path) : path_(std::move(path)) {}
    [[noreturn]] void at(int line, const std::string& reason) const {
        throw Error(ErrorKind::Input, path_ + ":" + std::to_string(line) + ": " + reason);
    }

  private:
    std::string path_;
};

bool isNameStart(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// What a file may not say: everything by which it could reach beyond its own functions.
const std::set<std::string, std::less<>> kForbidden{
    "layout",        "buffer",    "shared",    "attribute", "varying",   "coherent",  "volatile", "restrict",
    "subroutine",    "precision", "invariant", "precise",   "centroid",  "patch",     "sample",   "flat",
    "smooth",        "discard",   "barrier",   "atomicAdd", "atomicMin", "atomicMax", "double",   "goto",
    "noperspective", "readonly",  "writeonly", "asm",       "class",     "union",     "enum",     "typedef",
    "template",      "this",      "namespace", "using",     "switch",    "main"};

/// Types a parameter, function or constant may have.
const std::set<std::string, std::less<>> kTypes{"void",  "bool",  "int",   "uint",  "float", "vec2",  "vec3",
                                                "vec4",  "ivec2", "ivec3", "ivec4", "uvec2", "uvec3", "uvec4",
                                                "bvec2", "bvec3", "bvec4", "mat2",  "mat3",  "mat4"};

/// Names the program offers to a file.
const std::set<std::string, std::less<>> kOffered{"evaluate", "pdf", "sampleDirection"};

/// Blanks comments, keeping lines; their text is kept by line for the declarations of parameters.
std::string withoutComments(std::string_view text, std::map<int, std::string>& comments, const Refusal& refuse) {
    std::string result;
    int line = 1;
    for (std::size_t i = 0; i < text.size();) {
        if (text.substr(i, 2) == "//") {
            i += 2;
            for (; i < text.size() && text[i] != '\n'; ++i) comments[line] += text[i];
        } else if (text.substr(i, 2) == "/*") {
            const int begun = line;
            i += 2;
            while (i < text.size() && text.substr(i, 2) != "*/") {
                if (text[i] == '\n') {
                    result += '\n';
                    ++line;
                }
                ++i;
            }
            if (i >= text.size()) refuse.at(begun, "This comment does not end.");
            i += 2;
            result += ' ';
        } else {
            if (text[i] == '\n') ++line;
            result += text[i++];
        }
    }
    return result;
}

std::vector<Token> tokenize(const std::string& text, const Refusal& refuse) {
    static constexpr std::array<std::string_view, 20> kOperators{
        "<<=", ">>=", "++", "--", "+=", "-=", "*=", "/=", "%=", "&=",
        "|=",  "^=",  "==", "!=", "<=", ">=", "&&", "||", "^^", "<<"};
    std::vector<Token> tokens;
    int line = 1;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (c == '\n') ++line;
        if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
            ++i;
            continue;
        }
        if (tokens.size() >= kMaxUserBrdfTokens)
            refuse.at(line,
                      "The text is too long: more than " + std::to_string(kMaxUserBrdfTokens) + " words and signs.");
        std::size_t end = i + 1;
        if (isNameStart(c)) {
            while (end < text.size() && (isNameStart(text[end]) || isDigit(text[end]))) ++end;
        } else if (isDigit(c) || (c == '.' && end < text.size() && isDigit(text[end]))) {
            while (end < text.size() &&
                   (isNameStart(text[end]) || isDigit(text[end]) || text[end] == '.' ||
                    ((text[end] == '-' || text[end] == '+') && (text[end - 1] == 'e' || text[end - 1] == 'E'))))
                ++end;
        } else {
            if (c == '#') refuse.at(line, "Lines with # are not allowed: no #include, no #define.");
            if (std::string_view("+-*/%<>=!&|^~?:;,.(){}[]").find(c) == std::string_view::npos)
                refuse.at(line, std::string("There is a sign that GLSL does not have here") +
                                    (c >= ' ' && c < 127 ? std::string(": ") + c : std::string()) + ".");
            for (const std::string_view op : kOperators)
                if (text.compare(i, op.size(), op) == 0) {
                    end = i + op.size();
                    break;
                }
        }
        tokens.push_back({text.substr(i, end - i), line, isNameStart(c)});
        i = end;
    }
    return tokens;
}

/// Brackets match, and neither they nor statements grow without bound.
void checkShape(const std::vector<Token>& tokens, const Refusal& refuse) {
    std::vector<const Token*> open;
    std::size_t statement = 0;
    for (const Token& t : tokens) {
        if (++statement > kMaxUserBrdfStatement) refuse.at(t.line, "This statement is too long.");
        if (t.text == "(" || t.text == "{" || t.text == "[") {
            open.push_back(&t);
            if (open.size() > kMaxUserBrdfNesting) refuse.at(t.line, "Brackets are nested too deeply.");
        } else if (t.text == ")" || t.text == "}" || t.text == "]") {
            const char expected = t.text == ")" ? '(' : t.text == "}" ? '{' : '[';
            if (open.empty() || open.back()->text[0] != expected)
                refuse.at(t.line, "There is no bracket that this \"" + t.text + "\" closes.");
            open.pop_back();
        }
        if (t.text == ";" || t.text == "{" || t.text == "}") statement = 0;
    }
    if (!open.empty()) refuse.at(open.back()->line, "This \"" + open.back()->text + "\" is not closed.");
}

/// Removes and reads the declarations of parameters.
class ParameterReader {
  public:
    ParameterReader(UserBrdf& brdf, const std::map<int, std::string>& comments, const Refusal& refuse)
        : brdf_(brdf), comments_(comments), refuse_(refuse) {}

    /// tokens[i] is "uniform"; returns the token behind the declaration.
    std::size_t read(const std::vector<Token>& tokens, std::size_t i) {
        const int line = tokens[i].line;
        std::size_t end = i;
        while (end < tokens.size() && tokens[end].text != ";") ++end;
        const std::size_t count = end - i;
        const auto word = [&](std::size_t n) { return i + n < end ? tokens[i + n].text : std::string(); };
        if (end == tokens.size() || tokens[end].line != line)
            refuse_.at(line, "A parameter is declared in one line: uniform float name = 0.5;  // 0 to 1");
        if (word(1) == "vec3" && count == 3 && (word(2) == "albedo" || word(2) == "specular")) {
            (word(2) == "albedo" ? brdf_.usesAlbedo : brdf_.usesSpecular) = true;
            return end + 1;
        }
        const bool negative = word(4) == "-";
        if (word(1) != "float" || word(3) != "=" || count != (negative ? 6U : 5U))
            refuse_.at(line,
                       "A parameter is declared as: uniform float name = 0.5;  // 0 to 1, log, \"Label\"; colours are "
                       "uniform vec3 albedo; and uniform vec3 specular;");
        addParam(tokens[i + 2], (negative ? "-" : "") + word(negative ? 5 : 4));
        return end + 1;
    }

  private:
    float number(const std::string& text, int line) const {
        float value = 0;
        const char* last = text.data() + text.size();
        if (!text.empty() && (text.back() == 'f' || text.back() == 'F')) --last;
        const auto [end, code] = std::from_chars(text.data(), last, value);
        if (code != std::errc() || end != last || !std::isfinite(value))
            refuse_.at(line, "\"" + text + "\" is no number.");
        return value;
    }

    void addParam(const Token& name, const std::string& initial) {
        const int line = name.line;
        if (brdf_.params.size() == kBrdfValueCount)
            refuse_.at(line, "A BRDF has at most " + std::to_string(kBrdfValueCount) + " parameters.");
        static const std::set<std::string, std::less<>> kReserved{
            "brdf", "blend", "eta", "k", "fresnel", "metal", "albedo", "specular", "translucency", "drives"};
        if (kReserved.contains(name.text))
            refuse_.at(line, "A parameter cannot be called \"" + name.text + "\": edits have that key already.");
        const auto comment = comments_.find(line);
        std::vector<std::string> words;
        std::string label = name.text;
        if (comment != comments_.end()) {
            std::string text = comment->second;
            const std::size_t quote = text.find('"');
            const std::size_t last = text.rfind('"');
            if (quote != std::string::npos && last > quote + 1) {
                label = text.substr(quote + 1, last - quote - 1);
                text.resize(quote);
            }
            std::string current;
            for (const char c : text + " ") {
                if (c == ' ' || c == ',' || c == '\t' || c == '\r') {
                    if (!current.empty()) words.push_back(current);
                    current.clear();
                } else {
                    current += c;
                }
            }
        }
        const bool logScale = words.size() == 4 && words[3] == "log";
        if (words.size() < 3 || words[1] != "to" || (words.size() > 3 && !logScale))
            refuse_.at(line, "The range of \"" + name.text + "\" is missing: // least to greatest, then log if it is.");
        const float least = number(words[0], line);
        const float greatest = number(words[2], line);
        const float start = number(initial, line);
        if (!(least < greatest) || start < least || start > greatest || (logScale && least <= 0))
            refuse_.at(line, "\"" + name.text +
                                 "\" needs: least < greatest, the initial value between them, and least > 0 for log.");
        for (const ParamInfo& other : brdf_.params)
            if (name.text == other.key) refuse_.at(line, "\"" + name.text + "\" is declared twice.");
        const char* key = brdf_.texts.emplace_back(name.text).c_str();
        const char* shown = brdf_.texts.emplace_back(label).c_str();
        brdf_.params.push_back({key, shown, "", least, greatest, start, logScale});
    }

    UserBrdf& brdf_;
    const std::map<int, std::string>& comments_;
    const Refusal& refuse_;
};

/// Functions by name: where their bodies are, and what they call.
struct Function {
    int line = 0;
    std::size_t tokens = 0;
    std::vector<std::string> calls;
};

/// Tokens of a function once everything it calls stands in its place, which is what drivers make of it.
std::size_t expandedSize(const std::string& name, const std::map<std::string, Function>& functions,
                         std::map<std::string, std::size_t>& known, std::set<std::string>& open,
                         const Refusal& refuse) {
    if (const auto found = known.find(name); found != known.end()) return found->second;
    const Function& f = functions.at(name);
    if (!open.insert(name).second) refuse.at(f.line, "\"" + name + "\" calls itself; GLSL has no recursion.");
    std::size_t size = f.tokens;
    for (const std::string& callee : f.calls) {
        size += expandedSize(callee, functions, known, open, refuse);
        if (size > kMaxUserBrdfExpanded)
            refuse.at(f.line, "\"" + name + "\" is too long once the functions it calls are expanded.");
    }
    open.erase(name);
    return known[name] = size;
}

/// FNV-1a.
std::uint32_t hashOf(std::string_view text) {
    std::uint32_t hash = 2166136261U;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    return hash;
}

bool validUtf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto c = static_cast<unsigned char>(text[i]);
        const std::size_t more = c < 0x80 ? 0 : (c >> 5) == 6 ? 1 : (c >> 4) == 14 ? 2 : (c >> 3) == 30 ? 3 : 4;
        if (more == 4 || c == 0 || i + more >= text.size() + (more == 0 ? 1 : 0)) return false;
        for (std::size_t j = 1; j <= more; ++j)
            if ((static_cast<unsigned char>(text[i + j]) >> 6) != 2) return false;
        i += more + 1;
    }
    return true;
}

}  // namespace

UserBrdf parseUserBrdf(const std::string& path, std::string_view text) {
    const Refusal refuse(path);
    if (text.size() > kMaxUserBrdfBytes)
        refuse.at(1, "The file has " + std::to_string(text.size()) + " bytes, expected at most " +
                         std::to_string(kMaxUserBrdfBytes) + ".");
    if (!validUtf8(text)) refuse.at(1, "The file is no text in UTF-8.");
    UserBrdf brdf;
    brdf.path = path;
    brdf.revision = hashOf(text);
    std::map<int, std::string> comments;
    std::vector<Token> tokens = tokenize(withoutComments(text, comments, refuse), refuse);
    checkShape(tokens, refuse);
    for (const Token& t : tokens) {
        if (!t.name) continue;
        if (kForbidden.contains(t.text) || t.text.starts_with("gl_") || t.text.starts_with("image") ||
            t.text.starts_with("texture") || t.text.starts_with("texel") || t.text.starts_with("subgroup") ||
            t.text.starts_with("memoryBarrier") || t.text.starts_with("atomic"))
            refuse.at(t.line, "\"" + t.text + "\" is not allowed in a BRDF.");
        if (t.text.find("__") != std::string::npos || t.text.starts_with("user"))
            refuse.at(t.line,
                      "\"" + t.text + "\" is a reserved name: none may begin with \"user\" or have two underscores.");
    }

    // What stands outside functions: parameters are taken out, names of functions, constants and structs collected.
    ParameterReader reader(brdf, comments, refuse);
    std::vector<Token> kept;
    std::set<std::string> own;
    std::map<std::string, Function> functions;
    std::string inside;  // function whose body this is
    int depth = 0;
    for (std::size_t i = 0; i < tokens.size();) {
        const Token& t = tokens[i];
        if (depth == 0) {
            if (t.text == "uniform") {
                i = reader.read(tokens, i);
                continue;
            }
            const bool constant = t.text == "const";
            const std::size_t type = constant ? i + 1 : i;
            if (t.text == "struct" && type + 1 < tokens.size())
                own.insert(tokens[type + 1].text);
            else if (type + 2 < tokens.size() &&
                     (kTypes.contains(tokens[type].text) || own.contains(tokens[type].text)) && tokens[type + 1].name &&
                     (constant || tokens[type + 2].text == "(")) {
                own.insert(tokens[type + 1].text);
                if (!constant) {
                    inside = tokens[type + 1].text;
                    if (functions[inside].line == 0) functions[inside].line = t.line;
                }
            } else {
                refuse.at(t.line,
                          "Expected a function, a constant (const float a = 1.0;), a struct or a parameter "
                          "(uniform float a = 0.5;  // 0 to 1), found \"" +
                              t.text + "\".");
            }
            // To the end of the declaration, or the body's brace.
            int round = 0;
            while (i < tokens.size()) {
                const std::string& s = tokens[i].text;
                if (s == "(") ++round;
                if (s == ")") --round;
                kept.push_back(tokens[i++]);
                if (round == 0 && (s == ";" || s == "{")) {
                    if (s == "{") depth = 1;
                    break;
                }
            }
            continue;
        }
        if (t.text == "{") ++depth;
        if (t.text == "}") --depth;
        if (t.text == "uniform") refuse.at(t.line, "Parameters are declared outside functions.");
        if (!inside.empty()) {
            Function& f = functions[inside];
            ++f.tokens;
            if (t.name && i + 1 < tokens.size() && tokens[i + 1].text == "(" && own.contains(t.text) &&
                functions.contains(t.text) && (i == 0 || tokens[i - 1].text != "."))
                f.calls.push_back(t.text);
        }
        kept.push_back(t);
        ++i;
        if (depth == 0) inside.clear();
    }
    for (const std::string_view needed : kOffered)
        if (!functions.contains(std::string(needed)))
            refuse.at(1, "The file does not define " +
                             std::string(needed == "evaluate" ? "vec3 evaluate(vec3 wo, vec3 wi)"
                                         : needed == "pdf"    ? "float pdf(vec3 wo, vec3 wi)"
                                                              : "vec3 sampleDirection(vec3 wo, vec2 u)") +
                             ".");
    std::map<std::string, std::size_t> sizes;
    std::set<std::string> open;
    for (const auto& [name, function] : functions) expandedSize(name, functions, sizes, open, refuse);
    for (const ParamInfo& param : brdf.params) {
        if (own.contains(param.key)) refuse.at(1, "\"" + std::string(param.key) + "\" is declared twice.");
        own.insert(param.key);
        brdf.names.push_back(std::string(kUserBrdfPrefix) + param.key);
    }

    // Names become the file's own, and every loop asks userStep() before it goes on.
    std::vector<int> loops;  // brackets still open behind a for or while
    int semicolons = 0;
    int line = 1;
    std::vector<std::string> forState;
    struct Loop {
        int depth;
        bool isFor;
        int semicolon;
        bool conditionEmpty;
    };
    std::vector<Loop> stack;
    int round = 0;
    bool expectLoop = false;
    bool expectFor = false;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const Token& t = kept[i];
        while (line < t.line) {
            brdf.code += '\n';
            ++line;
        }
        if (t.text == "for" || t.text == "while") {
            expectLoop = true;
            expectFor = t.text == "for";
        }
        if (t.text == "(") ++round;
        if (t.text == ")" && !stack.empty() && stack.back().depth == round) {
            const Loop loop = stack.back();
            stack.pop_back();
            if (!loop.isFor) brdf.code += ")";
        }
        if (t.text == ")") --round;
        if (t.text == ";" && !stack.empty() && stack.back().isFor && stack.back().depth == round) {
            Loop& loop = stack.back();
            ++loop.semicolon;
            if (loop.semicolon == 1) {
                const bool empty = i + 1 < kept.size() && kept[i + 1].text == ";";
                loop.conditionEmpty = empty;
                brdf.code += empty ? "; userStep()" : "; userStep() && (";
                continue;
            }
            if (loop.semicolon == 2) {
                brdf.code += loop.conditionEmpty ? "; " : "); ";
                continue;
            }
        }
        const bool member = i > 0 && kept[i - 1].text == ".";
        if (t.name && !member && own.contains(t.text))
            brdf.code += std::string(kUserBrdfPrefix) + t.text + " ";
        else
            brdf.code += t.text + " ";
        if (t.text == "(" && expectLoop) {
            expectLoop = false;
            stack.push_back({round, expectFor, 0, false});
            if (!expectFor) brdf.code += "userStep() && (";
        }
    }
    static_cast<void>(loops);
    static_cast<void>(semicolons);
    static_cast<void>(forState);
    return brdf;
}

}  // namespace core
