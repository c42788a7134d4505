// The command line of one assignment's program.
//
//   PROGRAM open      [--scene S] [--set name=value]…                     the window
//   PROGRAM render    --scene S --size WxH [--set …]… --out DIR           one headless frame, as
//   files PROGRAM render    … --image visibility --frame-file FILE              the same for the
//   grader PROGRAM evaluate  --chunk F.glsl --expression E --inputs F --frame-file F   one GLSL
//   function PROGRAM benchmark --scene S… [--repeat N]                             cost in floors
//   PROGRAM list                                                          settings, ranges, units
#pragma once

#include <memory>
#include <string>

#include "app/assignment.h"

namespace penumbra {

// `layers`: the variant's folders, '|' between them. Exit code: 0 done, 2 bad input or a failure
// that one line on stderr explains, 69 no OpenGL on this machine.
int runAssignment(int argc, char** argv, const std::string& layers,
                  std::unique_ptr<Assignment> (*make)());

// "640x360" to pixels; throws Error outside 1 to 8192.
glm::ivec2 parseSize(const std::string& text);

}  // namespace penumbra
