#pragma once
/// The front page: what to take, what came out, the key figures. It is put together from what the chapters
/// give for it, and knows none of them.

#include <string>

#include "lab/report/page.hpp"

namespace flipside::lab::report {

[[nodiscard]] std::string front_html(const Page& page);

}  // namespace flipside::lab::report
