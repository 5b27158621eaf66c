// Words, rare notations of numbers, and errors.
#include "host/formats/obj/lines.h"

#include <fmt/format.h>

#include "host/base/quote.h"
#include "host/formats/loading/number.h"

namespace candela::obj {

using scene::NumberStatus;
using scene::quote;

Lines::Lines(std::string_view text) : next_(text.data()), end_(text.data() + text.size()) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) next_ += kByteOrderMark.size();
  lineBegin_ = next_;
}

Word Lines::word() {
  skipBlanks();
  const scene::Position position = here();
  if (endsLine()) return {{}, position};
  const char* const begin = next_;
  while (!endsWord(next_)) ++next_;
  return {{begin, static_cast<std::size_t>(next_ - begin)}, position};
}

Word Lines::rest() {
  skipBlanks();
  const scene::Position position = here();
  const char* const begin = next_;
  while (next_ != end_ && !isLineEnd(*next_) && !isContinuation(next_)) ++next_;
  const char* last = next_;
  while (last != begin && isBlank(last[-1])) --last;
  return {{begin, static_cast<std::size_t>(last - begin)}, position};
}

bool Lines::index(std::int64_t& value) {
  constexpr std::ptrdiff_t kMaxDigits = 15;
  const char* p = next_;
  std::int64_t digits = 0;
  while (p != end_ && *p >= '0' && *p <= '9' && p - next_ < kMaxDigits) digits = 10 * digits + (*p++ - '0');
  if (p != next_ && (endsWord(p) || *p == '/')) {  // the usual case: no sign
    next_ = p;
    value = digits;
    return true;
  }
  const auto [stop, error] = std::from_chars(next_, end_, value);
  if (error != std::errc() || !(endsWord(stop) || *stop == '/')) return false;
  next_ = stop;
  return true;
}

float Lines::otherNumber(std::string_view what) {
  const Word found = word();
  if (found.text.empty()) fail(found.position, fmt::format("expected {}", what));
  const scene::ParsedNumber<float> number = scene::parseFloat(found.text);
  switch (number.status) {
    case NumberStatus::ok:
      return number.value;
    case NumberStatus::notANumber:
      fail(found.position, fmt::format("expected {}, found {}", what, quote(found.text)));
    case NumberStatus::notFinite:
      fail(found.position, quote(found.text) + " is not a finite number");
    case NumberStatus::overflow:
      fail(found.position, quote(found.text) + " is beyond the range of single precision");
  }
  return 0;
}

void reportSurplus(Lines& lines, bool lenient, scene::DiagnosticLog& log) {
  const Word surplus = lines.word();
  const std::string message = "unexpected " + quote(surplus.text);
  if (lenient) {
    log.warn("surplus", surplus.position, message + "; skipped");
  } else {
    log.error(surplus.position, message);
  }
}

}  // namespace candela::obj
