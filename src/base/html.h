#pragma once

/// What pages with results have in common. Texts that come from outside pass through markup()
/// (base/text_format.h) before they become content.

#include <cstdint>
#include <span>
#include <string>

namespace haarlight {

/// RFC 4648, with padding.
std::string base64(std::span<const std::uint8_t> bytes);

/// An element around markup.
std::string element(const std::string& tag, const std::string& content,
                    const std::string& classes = {});

/// A heading with what follows it; empty without content.
std::string section(const std::string& title, const std::string& content);

/// A term of a <dl> and what it means; both are plain text.
std::string definition(const std::string& term, const std::string& text);

/// A table that scrolls where the page is too narrow for it.
std::string wideTable(const std::string& rows);

/// An image as a part of the page.
std::string pngImage(const std::string& label, std::span<const std::uint8_t> png);

/// A page of its own, without links to anything, for light and dark screens; well-formed as XML.
/// `style` is added to the common one, whose variables and classes it may use.
std::string htmlPage(const std::string& title, const std::string& style,
                     const std::string& content);

}  // namespace haarlight
