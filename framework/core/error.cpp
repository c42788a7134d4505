#include "core/error.h"

#include <cstdio>
#include <cstdlib>

namespace penumbra {

namespace {
std::string oneLine(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    return text;
}
}  // namespace

Error::Error(const std::string& what, const std::string& where, const std::string& whatToDo)
    : std::runtime_error(oneLine(what) + ": " + oneLine(where) + "; " + oneLine(whatToDo)) {}

void failExpectation(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: expectation failed: %s\n", file, line, condition);
    std::abort();
}

}  // namespace penumbra
