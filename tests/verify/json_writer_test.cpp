#include "verify/report/json_writer.h"

#include <bit>
#include <cstdlib>
#include <limits>

#include "report_test_support.h"
#include "test_support.h"

using namespace haarlight::test;
using haarlight::verify::JsonWriter;

namespace {

/// One value as JSON, without the newline.
template <typename Value>
std::string written(const Value& value) {
  const std::string text = JsonWriter().value(value).text();
  return text.substr(0, text.size() - 1);
}

}  // namespace

TEST_CASE("JSON is indented by two blanks") {
  JsonWriter json;
  json.beginObject().member("a", 1).key("b").beginArray().value(true).null().end();
  json.key("c").beginArray().end().key("d").beginObject().end().textOrNull("e", "").end();
  CHECK(json.text() ==
        "{\n  \"a\": 1,\n  \"b\": [\n    true,\n    null\n  ],\n  \"c\": [],\n  \"d\": {},\n"
        "  \"e\": null\n}\n");
}

TEST_CASE("JSON strings") {
  CHECK(written("a\"\\/\b\f\n\r\t") == R"("a\"\\/\b\f\n\r\t")");
  CHECK(written(std::string("\0\x1f\x7f", 3)) == "\"\\u0000\\u001f\x7f\"");
  CHECK(written("é€😀") == "\"é€😀\"");
}

TEST_CASE("bytes that are no UTF-8 become U+FFFD") {
  const std::string mark = "\uFFFD";
  CHECK(written("\x80") == "\"" + mark + "\"");
  CHECK(written("\xc3(") == "\"" + mark + "(\"");                                 // cut short
  CHECK(written("\xe2\x82") == "\"" + mark + mark + "\"");                        // cut by the end
  CHECK(written("\xc0\xaf") == "\"" + mark + mark + "\"");                        // overlong
  CHECK(written("\xe0\x80\xaf") == "\"" + mark + mark + mark + "\"");             // overlong
  CHECK(written("\xed\xa0\x80") == "\"" + mark + mark + mark + "\"");             // surrogate
  CHECK(written("\xf4\x90\x80\x80") == "\"" + mark + mark + mark + mark + "\"");  // above 10FFFF
  CHECK(written("\xf4\x8f\xbf\xbf") == "\"\xf4\x8f\xbf\xbf\"");
}

TEST_CASE("JSON numbers read back as they were") {
  for (const std::uint32_t bits :
       {0u, 0x80000000u, 1u, 0x007FFFFFu, 0x3F800001u, 0x7F7FFFFFu, 0x33800000u, 0xC2F6E979u}) {
    const std::string text = written(std::bit_cast<float>(bits));
    CHECK(readJson(text).at("") == text);
    CHECK(std::bit_cast<std::uint32_t>(std::strtof(text.c_str(), nullptr)) == bits);
  }
  for (const double number : {0.1, 1e22, 5e-324, -1.7976931348623157e308, 1.0 / 3}) {
    const std::string text = written(number);
    CHECK(readJson(text).at("") == text);
    CHECK(std::strtod(text.c_str(), nullptr) == number);
  }
  CHECK(written(std::numeric_limits<std::uint64_t>::max()) == "18446744073709551615");
  CHECK(written(std::numeric_limits<std::int64_t>::min()) == "-9223372036854775808");
}

TEST_CASE("JSON knows neither NaN nor infinities") {
  CHECK(written(std::numeric_limits<double>::quiet_NaN()) == "null");
  CHECK(written(std::numeric_limits<float>::infinity()) == "null");
  CHECK(written(-std::numeric_limits<double>::infinity()) == "null");
}

TEST_CASE("calls that would not give valid JSON are refused") {
  JsonWriter json;
  CHECK_THROWS_AS(json.text(), std::logic_error);
  CHECK_THROWS_AS(json.end(), std::logic_error);
  CHECK_THROWS_AS(json.key("a"), std::logic_error);
  json.beginObject();
  CHECK_THROWS_AS(json.value(1), std::logic_error);
  CHECK_THROWS_AS(json.beginArray(), std::logic_error);
  json.key("a");
  CHECK_THROWS_AS(json.key("b"), std::logic_error);
  CHECK_THROWS_AS(json.end(), std::logic_error);
  json.value(1);
  CHECK_THROWS_AS(json.key("a"), std::logic_error);
  CHECK_THROWS_AS(json.text(), std::logic_error);
  json.end();
  CHECK_THROWS_AS(json.value(1), std::logic_error);
  // A refused call has written nothing.
  CHECK(json.text() == "{\n  \"a\": 1\n}\n");
}
