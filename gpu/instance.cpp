// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/instance.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include "gpu/detail/instance_impl.h"
#include "gpu/detail/text.h"
#include "gpu/detail/vulkan_map.h"

namespace gpu {

namespace detail {

namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

bool layerInstalled() {
    std::uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    return std::any_of(layers.begin(), layers.end(),
                       [](const auto& layer) { return std::strcmp(layer.layerName, kValidationLayer) == 0; });
}

bool extensionInstalled(const char* layer, const char* name) {
    std::uint32_t count = 0;
    vkEnumerateInstanceExtensionProperties(layer, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateInstanceExtensionProperties(layer, &count, extensions.data());
    return std::any_of(extensions.begin(), extensions.end(),
                       [&](const auto& extension) { return std::strcmp(extension.extensionName, name) == 0; });
}

}  // namespace

VkDebugUtilsMessengerCreateInfoEXT ValidationListener::createInfo() {
    VkDebugUtilsMessengerCreateInfoEXT info = {};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    // No performance warnings: they object to images in GENERAL, which is our intended layout.
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    info.pfnUserCallback = &ValidationListener::onMessage;
    info.pUserData = this;
    return info;
}

void ValidationListener::attach(VkInstance instance) {
    const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance, "vkCreateDebugUtilsMessengerEXT"));
    const VkDebugUtilsMessengerCreateInfoEXT info = createInfo();
    require(create != nullptr, "VK_EXT_debug_utils is not enabled on the instance that is to be validated.");
    const VkResult result = create(instance, &info, nullptr, &messenger_);
    if (result != VK_SUCCESS) {
        throw Error(ErrorKind::Internal, text("Listening to the validation layer fails: ", toString(result), "."));
    }
    instance_ = instance;
}

ValidationListener::~ValidationListener() {
    if (messenger_ == VK_NULL_HANDLE) return;
    const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
    if (destroy != nullptr) destroy(instance_, messenger_, nullptr);
}

VkBool32 ValidationListener::onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                       const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    auto* self = static_cast<ValidationListener*>(user);
    ++self->count_;
    if (self->callback_) self->callback_(data->pMessage);
    if (!self->callback_ || self->mode_ == ValidationMode::Fatal) std::cerr << "Vulkan: " << data->pMessage << '\n';
    if (self->mode_ == ValidationMode::Fatal) std::abort();
    return VK_FALSE;
}

InstanceImpl::InstanceImpl(const InstanceDescriptor& descriptor) {
    VkApplicationInfo application = {};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.pApplicationName = "Patina";
    application.apiVersion = VK_API_VERSION_1_1;

    VkInstanceCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;

    std::vector<const char*> extensions;
    debugUtils = extensionInstalled(nullptr, VK_EXT_DEBUG_UTILS_EXTENSION_NAME);

    const std::array features = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    VkValidationFeaturesEXT validationFeatures = {};
    validationFeatures.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
    validationFeatures.enabledValidationFeatureCount = features.size();
    validationFeatures.pEnabledValidationFeatures = features.data();
    VkDebugUtilsMessengerCreateInfoEXT messenger = {};
    if (descriptor.validation != ValidationMode::Off) {
        if (!layerInstalled()) {
            throw Error(ErrorKind::Internal,
                        "Validation is requested (PATINA_VALIDATION), but the layer VK_LAYER_KHRONOS_validation is not "
                        "installed. On Debian and Ubuntu it is in the package vulkan-validationlayers.");
        }
        debugUtils = debugUtils || extensionInstalled(kValidationLayer, VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
        validation = std::make_unique<ValidationListener>(descriptor.validation, descriptor.validationCallback);
        info.enabledLayerCount = 1;
        info.ppEnabledLayerNames = &kValidationLayer;
        messenger = validation->createInfo();
        info.pNext = &messenger;
        if (extensionInstalled(kValidationLayer, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME)) {
            extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
            messenger.pNext = &validationFeatures;
        }
    }
    if (debugUtils) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();

    const VkResult result = vkCreateInstance(&info, nullptr, &vk);
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER) {
        throw Error(
            ErrorKind::NoAdapter,
            "The Vulkan loader finds no driver. A driver for Vulkan 1.1 is needed; without a GPU, Mesa's lavapipe "
            "(Debian and Ubuntu: mesa-vulkan-drivers) is one.");
    }
    if (result != VK_SUCCESS) {
        vk = VK_NULL_HANDLE;
        throw Error(ErrorKind::Internal, text("Creating the Vulkan instance fails: ", toString(result), "."));
    }
    if (validation) {
        try {
            validation->attach(vk);
        } catch (...) {
            vkDestroyInstance(vk, nullptr);
            throw;
        }
    }
}

InstanceImpl::~InstanceImpl() {
    validation.reset();
    if (vk != VK_NULL_HANDLE) vkDestroyInstance(vk, nullptr);
}

}  // namespace detail

namespace {

std::string lowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// Order of preference: lowest first.
int rank(AdapterType type) {
    switch (type) {
        case AdapterType::DiscreteGPU:
            return 0;
        case AdapterType::IntegratedGPU:
            return 1;
        case AdapterType::VirtualGPU:
            return 2;
        case AdapterType::CPU:
            return 3;
        case AdapterType::Unknown:
            break;
    }
    return 4;
}

std::string listOf(const std::vector<Adapter>& adapters) {
    std::string list;
    for (std::size_t i = 0; i < adapters.size(); ++i) {
        list += detail::text(i == 0 ? "" : ", ", i, ": \"", adapters[i].info().name, '"');
    }
    return list;
}

const Adapter& findNamed(const std::vector<Adapter>& adapters, const std::string& wish, const char* source) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(wish.data(), wish.data() + wish.size(), index);
    if (error == std::errc() && end == wish.data() + wish.size()) {
        if (index < adapters.size()) return adapters[index];
    } else {
        for (const Adapter& adapter : adapters) {
            if (lowerCase(adapter.info().name).find(lowerCase(wish)) != std::string::npos) return adapter;
        }
    }
    throw Error(ErrorKind::NoAdapter,
                detail::text("No device matches \"", wish, "\" (", source, "). There are: ", listOf(adapters), "."));
}

}  // namespace

ValidationMode validationModeFromEnvironment() {
    const char* value = std::getenv("PATINA_VALIDATION");
    if (value == nullptr || *value == 0 || std::strcmp(value, "0") == 0) return ValidationMode::Off;
    if (std::strcmp(value, "1") == 0) return ValidationMode::On;
    if (std::strcmp(value, "fatal") == 0) return ValidationMode::Fatal;
    throw Error(ErrorKind::Validation,
                detail::text("Environment variable PATINA_VALIDATION is \"", value, "\"; 0, 1 or fatal is expected."));
}

Instance Instance::create(const InstanceDescriptor& descriptor) {
    return Instance(std::make_shared<detail::InstanceImpl>(descriptor));
}

std::vector<Adapter> Instance::adapters() const {
    detail::require(impl_ != nullptr, "The instance is an empty handle.");
    std::uint32_t count = 0;
    VkResult result = vkEnumeratePhysicalDevices(impl_->vk, &count, nullptr);
    std::vector<VkPhysicalDevice> devices(count);
    if (result == VK_SUCCESS) result = vkEnumeratePhysicalDevices(impl_->vk, &count, devices.data());
    if (result != VK_SUCCESS && result != VK_INCOMPLETE) {
        // Without a working driver there is nothing to enumerate; requestAdapter reports that.
        return {};
    }
    std::vector<Adapter> adapters;
    for (std::uint32_t i = 0; i < count; ++i) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(devices[i], &properties);
        if (properties.apiVersion < VK_API_VERSION_1_1) continue;
        std::uint32_t familyCount = 0;
        vkGetPhysicalDeviceQueueFamilyProperties(devices[i], &familyCount, nullptr);
        std::vector<VkQueueFamilyProperties> families(familyCount);
        vkGetPhysicalDeviceQueueFamilyProperties(devices[i], &familyCount, families.data());
        const VkQueueFlags needed = VK_QUEUE_COMPUTE_BIT | VK_QUEUE_GRAPHICS_BIT;
        const auto family = std::find_if(families.begin(), families.end(),
                                         [&](const auto& f) { return (f.queueFlags & needed) == needed; });
        if (family == families.end()) continue;
        auto adapter = std::make_shared<detail::AdapterImpl>();
        adapter->instance = impl_;
        adapter->vk = devices[i];
        adapter->queueFamily = static_cast<std::uint32_t>(family - families.begin());
        adapter->info = detail::describeAdapter(devices[i]);
        adapter->limits = detail::queryLimits(devices[i], adapter->queueFamily);
        adapters.emplace_back(std::move(adapter));
    }
    return adapters;
}

Adapter Instance::requestAdapter(const RequestAdapterOptions& options) const {
    const std::vector<Adapter> all = adapters();
    if (all.empty()) {
        throw Error(ErrorKind::NoAdapter,
                    "No usable device: no Vulkan 1.1 driver offers a queue for compute and graphics. Without a GPU, "
                    "Mesa's lavapipe (Debian and Ubuntu: mesa-vulkan-drivers) is one.");
    }
    if (!options.device.empty()) return findNamed(all, options.device, "chosen explicitly");
    if (const char* wish = std::getenv("PATINA_DEVICE"); wish != nullptr && *wish != 0) {
        return findNamed(all, wish, "environment variable PATINA_DEVICE");
    }
    return *std::min_element(all.begin(), all.end(), [](const Adapter& a, const Adapter& b) {
        return rank(a.info().type) < rank(b.info().type);
    });
}

std::uint64_t Instance::validationMessageCount() const {
    detail::require(impl_ != nullptr, "The instance is an empty handle.");
    return impl_->validation ? impl_->validation->messageCount() : 0;
}

}  // namespace gpu
