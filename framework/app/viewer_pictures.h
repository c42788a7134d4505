// The frame's images as the window shows them: copies with 8 bits, so that a frame that fails later
// leaves the last good picture alone.
//
//   pictures.take(frame, "shadow_map");
//   const Texture& shown = pictures.compose(PictureView::split, 0.5f);
#pragma once

#include <string>

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "render/frame.h"

namespace penumbra {

enum class PictureView { picture, visibility, truth, difference, split };

class Pictures {
public:
    explicit Pictures(const Layers& layers);
    ~Pictures();
    Pictures(const Pictures&) = delete;
    Pictures& operator=(const Pictures&) = delete;

    // Copies colour, visibility and the image named `inset` (if the frame has it). Throws Error
    // when colour or visibility is missing.
    void take(const Frame& frame, const std::string& inset);
    void setTruth(const Image& truth);  // of visibility's size
    void dropTruth() { truth_ = Texture(); }
    bool hasTruth() const { return truth_.id() != 0; }
    bool ready() const { return color_.id() != 0; }

    // The view as RGBA8 of the frame's size. Where truth is missing, a neutral grey.
    const Texture& compose(PictureView view, float divider);
    // The named image, one channel as grey from its smallest to its largest value; id 0 if there is
    // none.
    const Texture& inset() const { return inset_; }
    glm::vec2 insetRange() const { return insetRange_; }
    Image visibility() const { return visibility_.read(); }

private:
    void draw(const Texture& target, const Program& program, const Texture& image) const;
    void drawColor(const Texture& target, const Texture& image, bool encode);
    void drawGrey(const Texture& target, const Texture& image, glm::vec2 range);
    void takeInset(const Frame& frame, const std::string& name);

    ShaderLibrary shaders_;
    GLuint vertexArray_ = 0, sampler_ = 0;
    Texture color_, visibility_, truth_, shown_, inset_, values_;
    glm::vec2 insetRange_{0, 1};
};

}  // namespace penumbra
