// EGL without a window system: Mesa's surfaceless platform, or a GPU's device. Opened at run time.
// [EGL_MESA_platform_surfaceless, EGL_EXT_platform_device]
#include <cstdint>
#include <cstring>

#include "core/error.h"
#include "gl/context.h"

#ifndef _WIN32
#include <dlfcn.h>
#endif

namespace penumbra {

#ifdef _WIN32
std::unique_ptr<Context> createEglContext(bool) {
    throw Error("EGL is not used on Windows", "libEGL", "use PENUMBRA_CONTEXT=window");
}
#else

namespace {

using Display = void*;
using Handle = void*;
using Enum = unsigned;

constexpr Enum kOpenGlApi = 0x30A2, kPlatformDevice = 0x313F, kPlatformSurfaceless = 0x31DD;
constexpr int kExtensions = 0x3055, kNone = 0x3038, kSurfaceType = 0x3033, kPbufferBit = 1,
              kRenderableType = 0x3040, kOpenGlBit = 8, kMajor = 0x3098, kMinor = 0x30FB,
              kProfileMask = 0x30FD, kCoreProfileBit = 1;

struct Egl {
    void (*(*getProcAddress)(const char*))();
    unsigned (*initialize)(Display, int*, int*);
    unsigned (*terminate)(Display);
    unsigned (*bindApi)(Enum);
    unsigned (*chooseConfig)(Display, const int*, Handle*, int, int*);
    Handle (*createContext)(Display, Handle, Handle, const int*);
    unsigned (*destroyContext)(Display, Handle);
    unsigned (*makeCurrent)(Display, Handle, Handle, Handle);
    Display (*getPlatformDisplay)(Enum, void*, const int*);
    unsigned (*queryDevices)(int, Handle*, int*);   // EGL_EXT_device_enumeration, may be null
    const char* (*queryDeviceString)(Handle, int);  // EGL_EXT_device_query, may be null
};

template <typename Function>
void find(void* library, Function& function, const char* name) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    if (!function) throw Error("EGL lacks a function", name, "install libegl1 with Mesa's drivers");
}

const Egl& egl() {
    static const Egl functions = [] {
        void* library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
        if (!library) throw Error("EGL is missing", "libEGL.so.1", "install libegl1");
        Egl f{};
        find(library, f.getProcAddress, "eglGetProcAddress");
        find(library, f.initialize, "eglInitialize");
        find(library, f.terminate, "eglTerminate");
        find(library, f.bindApi, "eglBindAPI");
        find(library, f.chooseConfig, "eglChooseConfig");
        find(library, f.createContext, "eglCreateContext");
        find(library, f.destroyContext, "eglDestroyContext");
        find(library, f.makeCurrent, "eglMakeCurrent");
        f.getPlatformDisplay = reinterpret_cast<decltype(f.getPlatformDisplay)>(
            f.getProcAddress("eglGetPlatformDisplayEXT"));
        f.queryDevices =
            reinterpret_cast<decltype(f.queryDevices)>(f.getProcAddress("eglQueryDevicesEXT"));
        f.queryDeviceString = reinterpret_cast<decltype(f.queryDeviceString)>(
            f.getProcAddress("eglQueryDeviceStringEXT"));
        if (!f.getPlatformDisplay)
            throw Error("EGL lacks platform displays", "libEGL.so.1",
                        "update Mesa or the GPU's driver");
        return f;
    }();
    return functions;
}

// The first device that is a GPU: Mesa lists its software rasteriser as a device too.
Handle gpuDevice() {
    Handle devices[16];
    int count = 0;
    if (!egl().queryDevices || !egl().queryDevices(16, devices, &count)) count = 0;
    for (int i = 0; i < count; ++i) {
        const char* extensions =
            egl().queryDeviceString ? egl().queryDeviceString(devices[i], kExtensions) : nullptr;
        if (!extensions || !std::strstr(extensions, "EGL_MESA_device_software")) return devices[i];
    }
    throw Error("no GPU among the EGL devices", "eglQueryDevicesEXT",
                "use egl-surfaceless or osmesa");
}

class EglContext final : public Context {
public:
    explicit EglContext(bool device) : device_(device) {
        display_ = device ? egl().getPlatformDisplay(kPlatformDevice, gpuDevice(), nullptr)
                          : egl().getPlatformDisplay(kPlatformSurfaceless, nullptr, nullptr);
        int major = 0, minor = 0;
        if (!display_ || !egl().initialize(display_, &major, &minor) || !egl().bindApi(kOpenGlApi))
            throw Error("EGL display does not start", backend(),
                        "install libgl1-mesa-dri or the GPU's driver");
        const int wanted[] = {kSurfaceType, kPbufferBit, kRenderableType, kOpenGlBit, kNone};
        Handle config = nullptr;
        int count = 0;
        egl().chooseConfig(display_, wanted, &config, 1, &count);
        const int attributes[] = {kMajor, 4, kMinor, 1, kProfileMask, kCoreProfileBit, kNone};
        context_ = egl().createContext(display_, count ? config : nullptr, nullptr, attributes);
        if (!context_ || !egl().makeCurrent(display_, nullptr, nullptr, context_)) {
            release();
            throw Error("EGL gives no OpenGL 4.1 core context", backend(),
                        "update Mesa or the GPU's driver");
        }
        load(egl().getProcAddress);
    }
    ~EglContext() override { release(); }
    std::string backend() const override { return device_ ? "egl-device" : "egl-surfaceless"; }

private:
    void release() {
        egl().makeCurrent(display_, nullptr, nullptr, nullptr);
        if (context_) egl().destroyContext(display_, context_);
        egl().terminate(display_);
    }
    bool device_;
    Display display_ = nullptr;
    Handle context_ = nullptr;
};

}  // namespace

std::unique_ptr<Context> createEglContext(bool device) {
    return std::make_unique<EglContext>(device);
}
#endif

}  // namespace penumbra
