// Compiled into every N.grade beside autograder/N/checks.cpp.
#include "core/grade.h"

int main(int argc, char** argv) {
    return penumbra::gradeMain(
        argc, argv,
        {.root = PENUMBRA_ROOT, .build = PENUMBRA_BUILD, .assignment = PENUMBRA_ASSIGNMENT});
}
