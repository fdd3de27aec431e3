// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"

namespace core {

/// A property or structure of an XMP packet. Valid as long as the Xmp it came from.
class XmpNode {
  public:
    explicit XmpNode(const pugi::xml_node& node) : node_(node) {}

    /// Text of a simple property `name` of the namespace `uri`, given as an attribute or as an element; nullopt = none.
    [[nodiscard]] std::optional<std::string> text(std::string_view uri, std::string_view name) const;
    /// The same as a number; nullopt also when the text is none.
    [[nodiscard]] std::optional<double> number(std::string_view uri, std::string_view name) const;
    /// A structure (rdf:parseType="Resource" or an rdf:Description inside); nullopt = none.
    [[nodiscard]] std::optional<XmpNode> child(std::string_view uri, std::string_view name) const;
    /// Items of a property that is an rdf:Seq, rdf:Bag or rdf:Alt; empty = none.
    [[nodiscard]] std::vector<XmpNode> items(std::string_view uri, std::string_view name) const;
    /// Such items as numbers; empty when one of them is none.
    [[nodiscard]] std::vector<double> numbers(std::string_view uri, std::string_view name) const;

  private:
    pugi::xml_node node_;
};

/// XMP packets of one file, parsed; properties are looked up in all of them, by namespace and not by prefix.
class Xmp {
  public:
    /// Texts that are no XML are left out, and described in `damage`.
    explicit Xmp(const std::vector<std::string>& packets, Message* damage = nullptr);

    [[nodiscard]] bool has(std::string_view uri, std::string_view name) const;
    /// As in XmpNode, of the picture itself: the first rdf:Description that has the property.
    [[nodiscard]] std::optional<std::string> text(std::string_view uri, std::string_view name) const;
    [[nodiscard]] std::optional<double> number(std::string_view uri, std::string_view name) const;
    [[nodiscard]] std::optional<XmpNode> child(std::string_view uri, std::string_view name) const;
    [[nodiscard]] std::vector<XmpNode> items(std::string_view uri, std::string_view name) const;
    [[nodiscard]] std::vector<double> numbers(std::string_view uri, std::string_view name) const;

  private:
    std::vector<std::unique_ptr<pugi::xml_document>> documents_;
    std::vector<XmpNode> descriptions_;
};

/// The XMP of a JPEG stream, standard and extended. What is wrong with it is described in `damage`.
[[nodiscard]] Xmp readJpegXmp(std::string_view stream, Message* damage = nullptr);

/// Base64 text, white space ignored, to bytes; nullopt when it contains anything else.
[[nodiscard]] std::optional<std::string> decodeBase64(std::string_view text);

}  // namespace core
