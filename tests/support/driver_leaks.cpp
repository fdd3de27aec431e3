// SPDX-License-Identifier: GPL-3.0-or-later
// Suppresses leaks of drivers, the validation layer, the encoder of test pictures (x265) and OpenImageIO's error
// messages. These libraries are usually unloaded before the leak check, which then cannot name them. Under
// AddressSanitizer they therefore stay loaded, so that their leaks can be suppressed by name.
#ifdef __SANITIZE_ADDRESS__
#include <dlfcn.h>

extern "C" int dlclose(void*) noexcept { return 0; }

extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libvulkan_lvp.so\nleak:libLLVM\nleak:libVkLayer_khronos_validation.so\nleak:libvulkan.so\n"
           "leak:libx265\nleak:OpenImageIO_v2_4::ImageInput::geterror\n";
}
#endif
