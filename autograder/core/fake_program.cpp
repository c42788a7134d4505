// Stands in for an assignment's program in the tests of the grader: renders a gradient, or
// misbehaves as the scene's name tells it to.
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <memory>
#include <vector>

#include "core/frame_file.h"

using namespace penumbra;

namespace {

struct Arguments {
    std::string mode, scene, expression, inputs, file;
    int width = 0, height = 0;
    std::string layer;  // what the student's gradient.glsl asks for
    std::vector<std::string> images;
};

// "behave crash" in gradient.glsl of a layer: as if the scene were named crash.
void readLayer(const std::string& folder, std::string& behaviour) {
    std::ifstream stream(folder + "/gradient.glsl");
    for (std::string word; stream >> word;)
        if (word == "behave") stream >> behaviour;
}

Arguments parse(int argc, char** argv) {
    Arguments a;
    a.mode = argv[1];
    for (int i = 2; i + 1 < argc; i += 2) {
        const std::string flag = argv[i], value = argv[i + 1];
        if (flag == "--scene") a.scene = value;
        if (flag == "--size") std::sscanf(value.c_str(), "%dx%d", &a.width, &a.height);
        if (flag == "--image") a.images.push_back(value);
        if (flag == "--expression") a.expression = value;
        if (flag == "--inputs") a.inputs = value;
        if (flag == "--frame-file") a.file = value;
        if (flag == "--layer") readLayer(value, a.layer);
    }
    return a;
}

void spin() {
    volatile long i = 0;
    for (;;) {
        const long next = i + 1;
        i = next;
    }
}

// Leaves a daemon behind that would outlive the program and hold its pipes open.
void daemonize(const std::string& pidFile) {
    if (fork() == 0) {
        setsid();
        if (fork() == 0) {
            std::ofstream(pidFile) << getpid() << std::endl;
            for (;;) pause();
        }
        _exit(0);
    }
    for (int i = 0; i < 200 && !std::filesystem::exists(pidFile); ++i) usleep(10000);
}

void misbehaveBefore(const Arguments& a) {
    if (a.scene == "crash") raise(SIGSEGV);
    if (a.scene == "abort") std::abort();
    if (a.scene == "hang") pause();
    if (a.scene == "spin") spin();
    if (a.scene == "ignore-signals") {
        signal(SIGTERM, SIG_IGN), signal(SIGINT, SIG_IGN), signal(SIGXCPU, SIG_IGN);
        spin();
    }
    if (a.scene == "exit-early") std::exit(0);
    if (a.scene == "no-opengl") {
        std::cerr << "no OpenGL context: llvmpipe; install Mesa\n";
        std::exit(69);
    }
    if (a.scene == "shader") {
        std::cerr << "noise\ndepth_bias.glsl:12: 'blokcer' undeclared\n";
        std::exit(2);
    }
    if (a.scene == "silent-failure") std::exit(3);
    if (a.scene == "chatter")
        for (int i = 0; i < 100000; ++i) std::cout << "0123456789abcdef\n";
    if (a.scene == "eat-memory") {
        std::vector<std::unique_ptr<std::vector<char>>> eaten;
        for (;;) eaten.push_back(std::make_unique<std::vector<char>>(8 << 20, 'x'));
    }
    if (a.scene == "fill-disk") {
        std::ofstream stream("big");
        const std::string block(1 << 20, 'x');
        for (int i = 0; i < 4096; ++i) stream << block << std::flush;
    }
    if (a.scene == "pipe-as-frame") mkfifo(a.file.c_str(), 0600);
    if (a.scene == "folder-as-frame") std::filesystem::create_directories(a.file + "/x");
    if (a.scene == "link-as-frame") std::filesystem::create_symlink("/etc/passwd", a.file);
    if (a.scene == "garbage") std::ofstream(a.file) << "PENUMBRA1\n9999999\n{";
    if (std::filesystem::exists(std::filesystem::symlink_status(a.file))) std::exit(0);
    if (a.scene.rfind("daemon:", 0) == 0) daemonize(a.scene.substr(7));
}

FrameFile draw(const Arguments& a) {
    FrameFile frame;
    const int width = a.scene == "wrong-size" ? a.width / 2 : a.width;
    for (const auto& name : a.images) {
        if (a.scene == "missing") continue;
        const int channels = name == "color" ? 3 : a.scene == "wrong-channels" ? 2 : 1;
        Image image(width, a.height, channels);
        for (int y = 0; y < a.height; ++y)
            for (int x = 0; x < width; ++x) image.at(x, y) = float(x) / float(a.width);
        if (a.scene == "unwritten") image = Image(width, a.height, channels, 1.0f);
        if (a.scene == "dark")
            for (float& v : image.pixels) v *= 0.5f;
        if (a.scene == "nan")
            for (int i = 0; i < 37; ++i)
                image.at(3 + i, 2) = std::numeric_limits<float>::quiet_NaN();
        if (a.scene == "infinity") image.at(1, 1) = std::numeric_limits<float>::infinity();
        frame.images[name] = image;
    }
    if (a.scene == "extra") frame.images["secret"] = Image(1, 1, 1);
    return frame;
}

// Environment as a picture of its length, so that a test sees what came through.
void reportEnvironment() {
    for (const char* name : {"PENUMBRA_CONTEXT", "LP_NUM_THREADS", "SECRET"}) {
        const char* value = std::getenv(name);
        std::cerr << name << "=" << (value ? value : "(none)") << " ";
    }
    char c;
    std::cerr << (read(0, &c, 1) == 0 ? "stdin empty" : "stdin open") << "\n";
    std::exit(1);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    Arguments a = parse(argc, argv);
    const bool solution = std::string(argv[0]).find(".solution") != std::string::npos;
    if (a.scene == "gradient")
        a.scene = !a.layer.empty() ? a.layer : solution ? "fine" : "unwritten";
    if (a.mode == "evaluate") {
        FrameFile answer;
        answer.images["result"] = loadFrameFile(a.inputs).images.at("a");
        for (float& v : answer.images["result"].pixels) v *= 2;
        if (a.expression == "nan") answer.images["result"].at(1, 0, 0) = std::nanf("");
        saveFrameFile(a.file, answer);
        return 0;
    }
    if (a.scene == "environment") reportEnvironment();
    misbehaveBefore(a);
    saveFrameFile(a.file, draw(a));
    if (a.scene == "crash-after") raise(SIGSEGV);
    if (a.scene == "fail-after") return 1;
    return 0;
}
