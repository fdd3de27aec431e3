// SPDX-License-Identifier: GPL-3.0-or-later
// What drivers, the validation layer, the encoder of test pictures (x265) and OpenImageIO's error messages leave behind
// is not ours to judge. They are unloaded before the leak check, which then cannot name them; so under AddressSanitizer
// libraries stay loaded, and leaks from these are not reported.
#ifdef __SANITIZE_ADDRESS__
#include <dlfcn.h>

extern "C" int dlclose(void*) noexcept { return 0; }

extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libvulkan_lvp.so\nleak:libLLVM\nleak:libVkLayer_khronos_validation.so\nleak:libvulkan.so\n"
           "leak:libx265\nleak:OpenImageIO_v2_4::ImageInput::geterror\n";
}
#endif
