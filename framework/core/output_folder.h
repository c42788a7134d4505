// Files that appear together or not at all.
//
//   OutputFolder out("out/frame");
//   saveExr(out.file("visibility.exr"), image);   // lands in a hidden folder beside the target
//   out.commit();                                 // moved into place; without it, everything goes
#pragma once

#include <filesystem>
#include <string>

namespace penumbra {

class OutputFolder {
public:
    // Throws Error when the folder cannot be made.
    explicit OutputFolder(std::filesystem::path target);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    std::filesystem::path file(const std::string& name) const { return part_ / name; }
    void commit();

private:
    std::filesystem::path target_, part_;
};

// Writes a text file under a temporary name and renames it. Throws Error.
void writeText(const std::filesystem::path& path, const std::string& text);

}  // namespace penumbra
