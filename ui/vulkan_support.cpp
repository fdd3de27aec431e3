// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/vulkan_support.h"

#include <QCoreApplication>
#include <QVersionNumber>
#include <QVulkanInstance>
#include <QVulkanWindow>

#include "gpu/adapter.h"
#include "gpu/instance.h"

namespace ui {

std::unique_ptr<QVulkanInstance> createVulkanInstance(QString& problem) {
    auto instance = std::make_unique<QVulkanInstance>();
    instance->setApiVersion(QVersionNumber(1, 1));
    instance->setFlags(QVulkanInstance::NoDebugOutputRedirect);
    if (gpu::validationModeFromEnvironment() != gpu::ValidationMode::Off) {
        instance->setLayers({"VK_LAYER_KHRONOS_validation"});
        instance->setExtensions({"VK_EXT_debug_utils"});
    }
    if (instance->create()) return instance;
    problem = QCoreApplication::translate(
                  "ui", "Vulkan is not available on this system (error %1), so the picture cannot be shown.")
                  .arg(static_cast<int>(instance->errorCode()));
    return nullptr;
}

void selectPhysicalDevice(QVulkanWindow& window, const QString& wish) {
    const gpu::AdapterInfo wanted = gpu::Instance::create().requestAdapter({.device = wish.toStdString()}).info();
    const auto devices = window.availablePhysicalDevices();
    for (int i = 0; i < devices.size(); ++i) {
        const VkPhysicalDeviceProperties& device = devices[i];
        if (device.vendorID == wanted.vendorId && device.deviceID == wanted.deviceId &&
            wanted.name == device.deviceName) {
            window.setPhysicalDeviceIndex(i);
            return;
        }
    }
    throw gpu::Error(gpu::ErrorKind::NoAdapter, "The device \"" + wanted.name + "\" cannot draw into a window.");
}

}  // namespace ui
