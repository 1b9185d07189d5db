#include "base/html.h"

#include <algorithm>
#include <cstddef>

#include "base/text_format.h"

namespace haarlight {

namespace {

constexpr char commonStyle[] = R"(
:root {
  color-scheme: light dark;
  --page: #fcfcfa; --text: #1d1f24; --soft: #62666f; --line: #d9d9d4; --group: #f1f1ec;
  --agrees: #17692f; --agrees-fill: #e0f2e4; --differs: #a4121b; --differs-fill: #fbe1e1;
  --within: #7a5200; --within-fill: #faefd2;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #16181c; --text: #e4e5e8; --soft: #9a9fa9; --line: #34373e; --group: #1f2228;
    --agrees: #86d89b; --agrees-fill: #17341f; --differs: #ff9a9a; --differs-fill: #471a1d;
    --within: #efc767; --within-fill: #3c3014;
  }
}
body { margin: 0; background: var(--page); color: var(--text);
       font: 15px/1.5 system-ui, "Segoe UI", "Helvetica Neue", Arial, sans-serif; }
main { max-width: 76rem; margin: 0 auto; padding: 2rem 1.5rem 4rem; }
h1 { font-size: 1.7rem; margin: 0 0 1rem; }
h2 { font-size: 1.2rem; margin: 2.5rem 0 .75rem; }
h3 { font-size: 1rem; margin: 2rem 0 .25rem; }
p { margin: .25rem 0 .75rem; }
.conclusion { padding: .7rem 1rem; border-radius: 6px; font-size: 1.1rem; font-weight: 600; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .15rem 1.25rem; margin: 1rem 0; }
dt { color: var(--soft); }
dd { margin: 0; overflow-wrap: anywhere; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .7rem; text-align: left; vertical-align: top;
         border-bottom: 1px solid var(--line); }
thead th { color: var(--soft); font-weight: 500; white-space: nowrap; }
th.group { background: var(--group); padding-top: .6rem; }
.number { text-align: right; white-space: nowrap; }
.agrees { color: var(--agrees); background: var(--agrees-fill); }
.differs { color: var(--differs); background: var(--differs-fill); }
.within { color: var(--within); background: var(--within-fill); }
code { font: .9em ui-monospace, Consolas, "DejaVu Sans Mono", monospace; white-space: nowrap; }
figure { margin: 1.25rem 0; }
figcaption { font-weight: 600; margin-bottom: .4rem; }
)";

}  // namespace

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t begin = 0; begin < bytes.size(); begin += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - begin);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i) group = group << 8 | (i < count ? bytes[begin + i] : 0u);
    for (std::size_t i = 0; i < 4; ++i)
      text += i <= count ? letters[group >> (18 - 6 * i) & 63] : '=';
  }
  return text;
}

std::string element(const std::string& tag, const std::string& content,
                    const std::string& classes) {
  const std::string attribute = classes.empty() ? "" : " class=\"" + classes + "\"";
  return "<" + tag + attribute + ">" + content + "</" + tag + ">";
}

std::string section(const std::string& title, const std::string& content) {
  return content.empty() ? "" : element("h2", title) + "\n" + content;
}

std::string definition(const std::string& term, const std::string& text) {
  return element("dt", markup(term)) + element("dd", markup(text)) + "\n";
}

std::string wideTable(const std::string& rows) {
  return element("div", element("table", rows), "wide") + "\n";
}

std::string pngImage(const std::string& label, std::span<const std::uint8_t> png) {
  return "<img alt=\"" + markup(label) + "\" src=\"data:image/png;base64," + base64(png) + "\"/>";
}

std::string htmlPage(const std::string& title, const std::string& style,
                     const std::string& content) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n" +
         element("title", markup(title)) + "\n" + element("style", commonStyle + style) +
         "\n</head>\n<body>\n<main>\n" + content + "</main>\n</body>\n</html>\n";
}

}  // namespace haarlight
