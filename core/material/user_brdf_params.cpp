// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/user_brdf_params.h"

#include <charconv>
#include <cmath>
#include <set>

namespace core {

namespace {

constexpr std::size_t kMaxLabel = 60;  // bytes
constexpr const char* kForm = "uniform float name = 0.5;  // 0 to 1, \"Label\"";

/// Keys of every edit, taken by the program.
const std::set<std::string, std::less<>> kTaken{"brdf",   "blend",    "eta",          "k",     "fresnel", "metal",
                                                "albedo", "specular", "translucency", "drives"};

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Removes the next word from `text`.
std::string_view word(std::string_view& text) {
    text = trimmed(text);
    const std::string_view result = text.substr(0, text.find_first_of(" \t"));
    text.remove_prefix(result.size());
    return result;
}

class ParamReader {
  public:
    ParamReader(const GlslText& text, std::size_t begin, const std::string& path, UserBrdfParams& params)
        : text_(text), begin_(begin), line_(text.tokens[begin].line), path_(path), result_(params) {}

    std::size_t read() {
        end_ = begin_;
        while (end_ < text_.tokens.size() && !token(end_ - begin_).is(";")) ++end_;
        if (end_ == text_.tokens.size() || text_.tokens[end_].line != line_)
            refuse(Message("messages", "A parameter is declared in one line: %1").with(kForm));
        if (end_ - begin_ == 3 && token(1).is("vec3") && (token(2).is("albedo") || token(2).is("specular"))) {
            (token(2).is("albedo") ? result_.usesAlbedo : result_.usesSpecular) = true;
            return end_ + 1;
        }
        const std::size_t sign = end_ - begin_ == 6 && token(4).is("-") ? 1 : 0;
        if (end_ - begin_ != 5 + sign || !token(1).is("float") || !token(2).isName() || !token(3).is("="))
            refuse(
                Message("messages",
                        "A parameter is declared as %1 and a colour as uniform vec3 albedo; or uniform vec3 specular;")
                    .with(kForm));
        addParam(token(2).text, (sign != 0 ? "-" : "") + token(4 + sign).text);
        return end_ + 1;
    }

  private:
    [[noreturn]] void refuse(const Message& reason) const { refuseGlsl(path_, line_, reason); }
    [[nodiscard]] const GlslToken& token(std::size_t n) const { return text_.tokens[begin_ + n]; }

    [[nodiscard]] float number(std::string_view text) const {
        const std::string whole(text);
        if (!text.empty() && (text.back() == 'f' || text.back() == 'F')) text.remove_suffix(1);
        float value = 0;
        const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (code != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
            refuse(Message("messages", "\"%1\" is no number.").with(whole));
        return value;
    }

    const char* keep(std::string_view text) { return result_.texts.emplace_back(text).c_str(); }

    void addParam(const std::string& name, const std::string& initial) {
        if (result_.params.size() == kBrdfValueCount)
            refuse(Message("messages", "A BRDF has at most %1 parameters.").with(kBrdfValueCount));
        if (kTaken.contains(name))
            refuse(Message("messages", "A parameter cannot be called \"%1\": edits have that key already.").with(name));
        for (const ParamInfo& other : result_.params)
            if (name == other.key) refuse(Message("messages", "The parameter \"%1\" is declared twice.").with(name));
        ParamInfo param{.key = keep(name),
                        .label = nullptr,
                        .unit = "",
                        .min = 0,
                        .max = 0,
                        .initial = number(initial),
                        .logScale = false};
        readComment(name, param);
        if (!(param.min < param.max) || param.initial < param.min || param.initial > param.max)
            refuse(Message("messages", "The range of \"%1\" has to rise and to contain its initial value.").with(name));
        if (param.logScale && param.min <= 0)
            refuse(Message("messages", "The range of \"%1\" is log and has to be above 0.").with(name));
        result_.params.push_back(param);
    }

    /// MIN to MAX [UNIT] [, log] [, "LABEL"]
    void readComment(const std::string& name, ParamInfo& param) {
        const auto comment = text_.lineComments.find(line_);
        std::string_view text = comment == text_.lineComments.end() ? std::string_view() : comment->second;
        std::string_view label = name;
        if (const std::size_t quote = text.find('"'); quote != std::string_view::npos) {
            const std::size_t end = text.find('"', quote + 1);
            if (end == std::string_view::npos)
                refuse(Message("messages", "The label of \"%1\" lacks its closing quote.").with(name));
            label = trimmed(text.substr(quote + 1, end - quote - 1));
            if (label.empty() || label.size() > kMaxLabel || !trimmed(text.substr(end + 1)).empty())
                refuse(Message("messages", "The label of \"%1\" stands last and has 1 to %2 characters.")
                           .with(name, kMaxLabel));
            text = text.substr(0, quote);
        }
        const std::size_t comma = text.find(',');
        std::string_view range = text.substr(0, comma);
        const std::string_view least = word(range);
        const std::string_view to = word(range);
        const std::string_view greatest = word(range);
        if (to != "to") refuse(Message("messages", "The range of \"%1\" is missing: %2").with(name, kForm));
        param.min = number(least);
        param.max = number(greatest);
        range = trimmed(range);
        if (range.size() > 12)
            refuse(Message("messages", "The unit of \"%1\" has more than 12 characters.").with(name));
        param.unit = keep(range);
        param.label = keep(label);
        if (comma == std::string_view::npos) return;
        std::string_view rest = trimmed(text.substr(comma + 1));
        if (rest.ends_with(',')) rest = trimmed(rest.substr(0, rest.size() - 1));
        param.logScale = rest == "log";
        if (!rest.empty() && !param.logScale)
            refuse(Message("messages",
                           "\"%1\" is not understood after the range of \"%2\", expected log or a label in quotes.")
                       .with(std::string(rest), name));
    }

    const GlslText& text_;
    std::size_t begin_;
    std::size_t end_ = 0;
    int line_;
    const std::string& path_;
    UserBrdfParams& result_;
};

}  // namespace

std::size_t readUserParam(const GlslText& text, std::size_t i, const std::string& path, UserBrdfParams& params) {
    return ParamReader(text, i, path, params).read();
}

}  // namespace core
