// The known mistakes of an assignment: each is a folder of wrong/ whose first line says what it
// fails.
//
//   // Fails: Task3DepthBias.NoAcneOnAPlane, Task2Compare.EqualIsLit · the bias has the wrong sign
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace penumbra {

struct Mistake {
    std::string folder;           // wrong_sign
    std::string name;             // the bias has the wrong sign
    std::set<std::string> fails;  // "Suite.Name"
};

// Sorted by folder. None where there is no wrong/: a tree handed to students has none. Throws Error
// for a mistake that does not say what it fails.
std::vector<Mistake> loadMistakes(const std::filesystem::path& wrong);

// The names of the mistakes that fail exactly these checks; else the closest by shared checks, if
// at least half are shared; else "".
std::string looksLike(const std::vector<Mistake>& mistakes, const std::set<std::string>& failed);

}  // namespace penumbra
