// OSMesa is opened at run time, so that one binary serves where it is missing. [Mesa
// OSMesa/osmesa.h]
#include "core/error.h"
#include "gl/context.h"

#ifndef _WIN32
#include <dlfcn.h>
#endif

namespace penumbra {

#ifdef _WIN32
std::unique_ptr<Context> createOsmesaContext() {
    throw Error("OSMesa is not used on Windows", "libOSMesa", "use PENUMBRA_CONTEXT=window");
}
#else

namespace {

constexpr int kOsmesaFormat = 0x22, kOsmesaRgba = 0x1908, kOsmesaDepthBits = 0x30,
              kOsmesaStencilBits = 0x31, kOsmesaProfile = 0x33, kOsmesaCoreProfile = 0x34,
              kOsmesaMajor = 0x36, kOsmesaMinor = 0x37;

struct Osmesa {
    void* (*createContextAttribs)(const int*, void*);
    unsigned char (*makeCurrent)(void*, void*, unsigned, int, int);
    void (*destroyContext)(void*);
    void (*(*getProcAddress)(const char*))();
};

const Osmesa& osmesa() {
    static const Osmesa functions = [] {
        void* library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
        if (!library) library = dlopen("libOSMesa.so", RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
        if (!library) throw Error("OSMesa is missing", "libOSMesa.so.8", "install libosmesa6");
        Osmesa f{};
        f.createContextAttribs = reinterpret_cast<decltype(f.createContextAttribs)>(
            dlsym(library, "OSMesaCreateContextAttribs"));
        f.makeCurrent =
            reinterpret_cast<decltype(f.makeCurrent)>(dlsym(library, "OSMesaMakeCurrent"));
        f.destroyContext =
            reinterpret_cast<decltype(f.destroyContext)>(dlsym(library, "OSMesaDestroyContext"));
        f.getProcAddress =
            reinterpret_cast<decltype(f.getProcAddress)>(dlsym(library, "OSMesaGetProcAddress"));
        if (!f.createContextAttribs || !f.makeCurrent || !f.destroyContext || !f.getProcAddress)
            throw Error("OSMesa lacks a function", "libOSMesa.so.8",
                        "install libosmesa6 22 or newer");
        return f;
    }();
    return functions;
}

class OsmesaContext final : public Context {
public:
    OsmesaContext() {
        const int attributes[] = {kOsmesaFormat,
                                  kOsmesaRgba,
                                  kOsmesaDepthBits,
                                  0,
                                  kOsmesaStencilBits,
                                  0,
                                  kOsmesaProfile,
                                  kOsmesaCoreProfile,
                                  kOsmesaMajor,
                                  4,
                                  kOsmesaMinor,
                                  1,
                                  0};
        context_ = osmesa().createContextAttribs(attributes, nullptr);
        if (!context_ || !osmesa().makeCurrent(context_, pixels_, GL_UNSIGNED_BYTE, kSide, kSide)) {
            if (context_) osmesa().destroyContext(context_);
            throw Error("OSMesa gives no OpenGL 4.1 core context", "libOSMesa", "update Mesa");
        }
        load(osmesa().getProcAddress);
    }
    ~OsmesaContext() override {
        osmesa().makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        osmesa().destroyContext(context_);
    }
    std::string backend() const override { return "osmesa"; }

private:
    static constexpr int kSide = 8;  // the default framebuffer is never drawn to
    unsigned char pixels_[4 * kSide * kSide] = {};
    void* context_ = nullptr;
};

}  // namespace

std::unique_ptr<Context> createOsmesaContext() { return std::make_unique<OsmesaContext>(); }
#endif

}  // namespace penumbra
