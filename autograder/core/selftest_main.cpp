// The grader on core/selftest: a tree with handout, solution and mistakes that fake_program
// renders.
#include "core/grade.h"

int main(int argc, char** argv) {
    return penumbra::gradeMain(
        argc, argv,
        {.root = PENUMBRA_SELFTEST, .build = PENUMBRA_SELFTEST_BUILD, .assignment = "00-fake"});
}
