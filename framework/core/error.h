// The two kinds of failure that stop work; a normal "none" is std::optional instead.
//
//   throw Error("cannot open model", path.string(), "check the path or run ./course list");
//   EXPECTS(width > 0);   // our own mistake: stops with file and line
#pragma once

#include <stdexcept>
#include <string>

namespace penumbra {

// The outside world went wrong (file, driver, shader text, command line). what() is the one line a
// person reads: "<what>: <where>; <what to do>".
class Error : public std::runtime_error {
public:
    Error(const std::string& what, const std::string& where, const std::string& whatToDo);
};

[[noreturn]] void failExpectation(const char* condition, const char* file, int line);

}  // namespace penumbra

#define EXPECTS(condition) \
    ((condition) ? (void)0 : ::penumbra::failExpectation(#condition, __FILE__, __LINE__))
