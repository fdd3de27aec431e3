// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>

class QVulkanInstance;
class QVulkanWindow;

namespace ui {

/// Vulkan for windows, with the validation layer when PATINA_VALIDATION asks for it; nullptr, and the reason in
/// `problem`, when this machine or Qt platform has none.
[[nodiscard]] std::unique_ptr<QVulkanInstance> createVulkanInstance(QString& problem);

/// Makes the window use the device that gpu::Instance::requestAdapter would take for `wish`. Throws
/// gpu::Error when there is none.
void selectPhysicalDevice(QVulkanWindow& window, const QString& wish);

}  // namespace ui
