// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/glsl_tokens.h"

#include <array>

#include "core/base/error.h"

namespace core {

namespace {

bool isNameStart(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

bool validUtf8(std::string_view text) {
    std::size_t i = 0;
    while (i < text.size()) {
        const auto c = static_cast<unsigned char>(text[i++]);
        if (c == 0) return false;
        int more = 0;
        if (c >= 0xc2 && c < 0xe0) more = 1;
        if (c >= 0xe0 && c < 0xf0) more = 2;
        if (c >= 0xf0 && c < 0xf5) more = 3;
        if (c >= 0x80 && more == 0) return false;
        for (; more > 0; --more)
            if (i == text.size() || (static_cast<unsigned char>(text[i++]) & 0xc0U) != 0x80) return false;
    }
    return true;
}

class Tokenizer {
  public:
    Tokenizer(const std::string& path, std::string_view text) : path_(path), text_(text) {}

    GlslText run() {
        while (at_ < text_.size()) {
            if (text_[at_] == '\n') ++line_;
            if (isSpace(text_[at_])) {
                ++at_;
            } else if (text_.substr(at_, 2) == "//") {
                lineComment();
            } else if (text_.substr(at_, 2) == "/*") {
                blockComment();
            } else {
                token();
            }
        }
        return std::move(result_);
    }

  private:
    [[noreturn]] void refuse(const Message& reason) const { refuseGlsl(path_, line_, reason); }

    void lineComment() {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        result_.lineComments[line_] = text_.substr(at_ + 2, end - at_ - 2);
        at_ = end;
    }

    void blockComment() {
        const std::size_t end = text_.find("*/", at_ + 2);
        if (end == std::string_view::npos) refuse(Message("messages", "This comment does not end."));
        for (; at_ < end; ++at_)
            if (text_[at_] == '\n') ++line_;
        at_ = end + 2;
    }

    void token() {
        if (result_.tokens.size() == kMaxGlslTokens)
            refuse(Message("messages", "The text is too long: more than %1 words and signs.").with(kMaxGlslTokens));
        const char c = text_[at_];
        const char next = at_ + 1 < text_.size() ? text_[at_ + 1] : ' ';
        GlslToken token{.text = {}, .line = line_, .kind = GlslToken::Kind::Sign};
        std::size_t length = 1;
        if (isNameStart(c)) {
            token.kind = GlslToken::Kind::Name;
            length = nameLength();
        } else if (isDigit(c) || (c == '.' && isDigit(next))) {
            token.kind = GlslToken::Kind::Number;
            length = numberLength();
        } else {
            length = signLength();
        }
        token.text = text_.substr(at_, length);
        at_ += length;
        result_.tokens.push_back(std::move(token));
    }

    [[nodiscard]] std::size_t nameLength() const {
        std::size_t end = at_;
        while (end < text_.size() && (isNameStart(text_[end]) || isDigit(text_[end]))) ++end;
        if (end - at_ > kMaxGlslName)
            refuse(Message("messages", "A name has more than %1 characters.").with(kMaxGlslName));
        return end - at_;
    }

    [[nodiscard]] std::size_t numberLength() const {
        std::size_t end = at_;
        const auto exponentSign = [&] {
            return (text_[end] == '-' || text_[end] == '+') && (text_[end - 1] == 'e' || text_[end - 1] == 'E') &&
                   text_.substr(at_, 2) != "0x";
        };
        while (end < text_.size() &&
               (isNameStart(text_[end]) || isDigit(text_[end]) || text_[end] == '.' || (end > at_ && exponentSign())))
            ++end;
        const std::string_view number = text_.substr(at_, end - at_);
        if (number.size() > kMaxGlslName || number.find_first_of("lLhH_") != std::string_view::npos)
            refuse(Message("messages", "\"%1\" is no int, uint or float.")
                       .with(std::string(number.substr(0, kMaxGlslName))));
        return end - at_;
    }

    [[nodiscard]] std::size_t signLength() const {
        static constexpr std::array<std::string_view, 20> kSigns{
            "<<=", ">>=", "++", "--", "+=", "-=", "*=", "/=", "&=", "|=",
            "^=",  "==",  "!=", "<=", ">=", "&&", "||", "^^", "<<", ">>"};
        const char c = text_[at_];
        if (c == '#')
            refuse(Message("messages",
                           "Lines with # are not allowed here: no #include, #define, #extension or #version."));
        if (c == '%') refuse(Message("messages", "There is no % here; mod(x, y) does it for floats."));
        if (std::string_view("+-*/<>=!&|^~?:;,.(){}[]").find(c) == std::string_view::npos)
            refuse(c > ' ' && c < 127 ? Message("messages", "The sign %1 is not allowed here.").with(std::string(1, c))
                                      : Message("messages", "There is a character here that is not GLSL."));
        for (const std::string_view sign : kSigns)
            if (text_.substr(at_, sign.size()) == sign) return sign.size();
        return 1;
    }

    const std::string& path_;
    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    GlslText result_;
};

/// Throws unless brackets match and nesting and statements stay within the limits.
void checkShape(const std::string& path, const std::vector<GlslToken>& tokens) {
    std::vector<const GlslToken*> open;
    std::size_t statement = 0;
    int elses = 0;
    for (const GlslToken& t : tokens) {
        if (++statement > kMaxGlslStatement)
            refuseGlsl(path, t.line, Message("messages", "This statement is too long."));
        if (t.is("else") && ++elses > kMaxGlslElses)
            refuseGlsl(path, t.line, Message("messages", "There are too many \"else\"."));
        if (t.is("(") || t.is("{") || t.is("[")) {
            open.push_back(&t);
            if (open.size() > kMaxGlslNesting)
                refuseGlsl(path, t.line, Message("messages", "Brackets are nested too deeply."));
        } else if (t.is(")") || t.is("}") || t.is("]")) {
            const char* expected = t.is(")") ? "(" : t.is("}") ? "{" : "[";
            if (open.empty() || !open.back()->is(expected))
                refuseGlsl(path, t.line,
                           Message("messages", "There is no bracket that this \"%1\" closes.").with(t.text));
            open.pop_back();
        }
        if (t.is(";") || t.is("{") || t.is("}")) statement = 0;
    }
    if (!open.empty())
        refuseGlsl(path, open.back()->line, Message("messages", "This \"%1\" is not closed.").with(open.back()->text));
}

}  // namespace

void refuseGlsl(const std::string& path, int line, const Message& reason) {
    throw Error(ErrorKind::Input, Message("messages", "%1:%2: %3").with(path, line, reason));
}

GlslText tokenizeGlsl(const std::string& path, std::string_view text) {
    if (!validUtf8(text)) refuseGlsl(path, 1, Message("messages", "The file is no text in UTF-8."));
    GlslText result = Tokenizer(path, text).run();
    checkShape(path, result.tokens);
    return result;
}

}  // namespace core
