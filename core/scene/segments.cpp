// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/segments.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "core/base/error.h"
#include "core/base/label_table.h"
#include "core/scene/segment_areas.h"

namespace core {

namespace {

constexpr int kLargestLabel = 65535;

[[noreturn]] void refuse(Message message) { throw Error(ErrorKind::Usage, std::move(message)); }

void addNote(Notes* notes, Message note) {
    if (notes != nullptr) notes->push_back(std::move(note));
}

/// A sentence about each segment, or one with their number when they are many; %2 is `value`.
void noteSegments(Notes* notes, const std::vector<const Segment*>& about, const Message& one, const Message& many,
                  const Message& value = {}) {
    constexpr std::size_t kNamed = 4;
    if (about.size() > kNamed) return addNote(notes, many.with(about.size(), value));
    for (const Segment* segment : about) addNote(notes, one.with(segment->name, value));
}

/// A whole number, of any size; nullopt for other texts.
std::optional<long> wholeNumber(const std::string& text) {
    long value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size() || text.empty()) return std::nullopt;
    return code == std::errc() ? value : std::optional<long>(-1);
}

/// The smallest labels without a segment, at most `count`.
std::vector<std::uint16_t> freeLabels(const Scene& scene, std::size_t count) {
    LabelTable<char> taken(0);
    for (const Segment& segment : scene.segments) taken[segment.label] = 1;
    std::vector<std::uint16_t> free;
    for (int label = 1; label <= kLargestLabel && free.size() < count; ++label)
        if (taken[static_cast<std::size_t>(label)] == 0) free.push_back(static_cast<std::uint16_t>(label));
    return free;
}

std::vector<std::uint16_t> requireFreeLabels(const Scene& scene, std::size_t count) {
    std::vector<std::uint16_t> free = freeLabels(scene, count);
    if (free.empty())
        refuse(Message("messages", "The project has %1 segments already, no label is free.").with(kLargestLabel));
    if (free.size() < count)
        refuse(
            Message("messages", "This needs %1 new segments, but only %2 labels are free.").with(count, free.size()));
    return free;
}

/// Hands out names that no segment has.
class SegmentNames {
  public:
    explicit SegmentNames(const Scene& scene) {
        for (const Segment& segment : scene.segments) taken_.insert(segment.name);
    }
    /// The name itself if it is free, otherwise a numbered one.
    std::string free(const std::string& name) { return taken_.insert(name).second ? name : numbered(name, 2); }
    /// "vase 2" after "vase" or "vase 1".
    std::string numbered(const std::string& name, int first) {
        const std::size_t end = name.find_last_not_of("0123456789");
        const bool hasNumber = end != std::string::npos && end > 0 && end + 1 < name.size() && name[end] == ' ';
        const std::string stem = hasNumber ? name.substr(0, end) : name;
        int& number = next_.try_emplace(stem, first).first->second;
        for (;; ++number)
            if (std::string text = stem + ' ' + std::to_string(number); taken_.insert(text).second) return text;
    }

  private:
    std::set<std::string> taken_;
    std::map<std::string, int> next_;  ///< first number to try, by stem
};

void requirePixels([[maybe_unused]] const Scene& scene, const BinaryMask& mask) {
    CORE_ASSERT(mask.sameSize(scene.photo->labels), "a mask has the photograph's size");
    if (std::ranges::all_of(mask.pixels(), [](std::uint8_t value) { return value == 0; }))
        refuse(Message("messages", "Nothing is selected, so there is no segment to make."));
}

const Segment& requireSegment(const Scene& scene, std::uint16_t label) {
    const Segment* segment = scene.findSegment(label);
    if (segment == nullptr) refuse(Message("messages", "There is no segment with the label %1.").with(label));
    return *segment;
}

/// The segments of some labels, each once, in this order.
std::vector<const Segment*> requireSegments(const Scene& scene, std::span<const std::uint16_t> labels) {
    LabelTable<const Segment*> known(nullptr);
    for (const Segment& segment : scene.segments) known[segment.label] = &segment;
    std::vector<const Segment*> result;
    LabelTable<char> seen(0);
    for (const std::uint16_t label : labels) {
        if (known[label] == nullptr) (void)requireSegment(scene, label);
        if (seen[label] == 0) result.push_back(known[label]);
        seen[label] = 1;
    }
    return result;
}

[[noreturn]] void refuseLocked(const Segment& segment) {
    refuse(Message("messages", "The segment \"%1\" is locked. Unlock it to change its pixels.").with(segment.name));
}

void noteLocked(Notes* notes, const std::vector<const Segment*>& locked) {
    noteSegments(notes, locked, Message("messages", "The segment \"%1\" is locked and stays as it is."),
                 Message("messages", "%1 segments are locked and stay as they are."));
}

const Segment& requireUnlocked(const Scene& scene, std::uint16_t label) {
    const Segment& segment = requireSegment(scene, label);
    if (segment.locked) refuseLocked(segment);
    return segment;
}

/// A scene whose labels are being changed.
class Relabelling {
  public:
    Relabelling(const Scene& scene, Notes* notes)
        : scene_(scene), photo_(std::make_shared<Photo>(*scene.photo)), notes_(notes), locked_(nullptr), known_(0) {
        for (const Segment& segment : scene.segments) {
            known_[segment.label] = 1;
            if (segment.locked) locked_[segment.label] = &segment;
        }
    }

    [[nodiscard]] Scene& scene() { return result_; }
    [[nodiscard]] LabelImage& labels() { return photo_->labels; }

    /// Gives a label to the pixels that `chosen` says; refuses when locked segments have all of them.
    template <class Chosen>
    void assign(const Chosen& chosen) {
        std::set<std::uint16_t> kept;
        bool any = false;
        for (std::size_t i = 0; i < photo_->labels.size(); ++i) {
            const std::optional<std::uint16_t> label = chosen(i);
            if (!label) continue;
            std::uint16_t& pixel = photo_->labels[i];
            if (locked_[pixel] != nullptr) {
                if (kept.empty() || !kept.contains(pixel)) kept.insert(pixel);
                continue;
            }
            pixel = *label;
            any = true;
        }
        if (!any && !kept.empty()) refuseLocked(*locked_[*kept.begin()]);
        std::vector<const Segment*> segments;
        for (const std::uint16_t label : kept) segments.push_back(locked_[label]);
        noteSegments(notes_, segments, Message("messages", "The segment \"%1\" is locked and keeps its pixels."),
                     Message("messages", "%1 segments are locked and keep their pixels."));
    }
    void assign(const BinaryMask& mask, std::uint16_t label) {
        assign([&](std::size_t i) { return mask[i] != 0 ? std::optional(label) : std::nullopt; });
    }

    Scene finish() {
        if (photo_->labels == scene_.photo->labels) return std::move(result_);
        std::ranges::sort(result_.segments, {}, &Segment::label);
        dropEmptySegments();
        photo_->source.segments.clear();
        result_.photo = std::move(photo_);
        return std::move(result_);
    }

  private:
    void dropEmptySegments() {
        LabelTable<char> present(0);
        for (const std::uint16_t label : photo_->labels.pixels()) present[label] = 1;
        std::vector<const Segment*> empty;
        for (const Segment& segment : result_.segments) {
            if (present[segment.label] != 0) continue;
            if (segment.edit)
                refuse(Message("messages",
                               "The segment \"%1\" would lose all of its pixels, but it is edited. Lock it to keep "
                               "it, or delete it.")
                           .with(segment.name));
            // New ones that got no pixel are nothing to speak of.
            if (known_[segment.label] != 0) empty.push_back(&segment);
        }
        noteSegments(notes_, empty,
                     Message("messages", "The segment \"%1\" is gone, because it lost all of its pixels."),
                     Message("messages", "%1 segments are gone, because they lost all of their pixels."));
        std::erase_if(result_.segments, [&](const Segment& segment) { return present[segment.label] == 0; });
    }

    const Scene& scene_;
    Scene result_ = scene_;
    std::shared_ptr<Photo> photo_;
    Notes* notes_;
    LabelTable<const Segment*> locked_;
    LabelTable<char> known_;  ///< labels that have had a segment before
};

std::uint16_t newLabel(const Scene& scene, const std::string& labelOrName) {
    const std::optional<long> number = wholeNumber(labelOrName);
    if (!number) return requireFreeLabels(scene, 1).front();
    if (*number < 1 || *number > kLargestLabel)
        refuse(Message("messages", "The label of a segment is \"%1\", expected 1 to %2.")
                   .with(labelOrName, kLargestLabel));
    return static_cast<std::uint16_t>(*number);
}

/// Objects of a label map in the order of their labels, with their pixels and how many of them are not in a segment.
struct FoundObject {
    std::uint16_t label = 0;
    std::size_t pixels = 0;
    std::size_t free = 0;
};

std::vector<FoundObject> foundObjects(const Scene& scene, const LabelImage& objects) {
    CORE_ASSERT(objects.sameSize(scene.photo->labels), "a label map has the photograph's size");
    LabelTable<FoundObject> table;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (objects[i] == 0) continue;
        ++table[objects[i]].pixels;
        if (scene.photo->labels[i] == 0) ++table[objects[i]].free;
    }
    std::vector<FoundObject> found;
    for (std::size_t label = 1; label < table.size(); ++label) {
        if (table[label].pixels == 0) continue;
        table[label].label = static_cast<std::uint16_t>(label);
        found.push_back(table[label]);
    }
    return found;
}

Segment segmentCalled(std::uint16_t label, std::string name) {
    Segment segment;
    segment.label = label;
    segment.name = std::move(name);
    return segment;
}

}  // namespace

Scene withSegment(const Scene& scene, const BinaryMask& mask, const std::string& labelOrName, Notes* notes) {
    requirePixels(scene, mask);
    if (labelOrName.empty()) refuse(Message("messages", "The name of the segment is empty."));
    Scene known = scene;
    const Segment* segment = known.findSegment(labelOrName);
    const std::uint16_t label = segment != nullptr ? segment->label : newLabel(scene, labelOrName);
    if (scene.findSegment(label) != nullptr) return combineSegment(scene, label, mask, MaskUse::Replace, notes);
    Relabelling change(scene, notes);
    std::string name = wholeNumber(labelOrName) ? "segment " + std::to_string(label) : labelOrName;
    while (known.findSegment(name) != nullptr) name += "'";
    change.scene().segments.push_back(segmentCalled(label, std::move(name)));
    change.assign(mask, label);
    return change.finish();
}

Scene combineSegment(const Scene& scene, std::uint16_t label, const BinaryMask& mask, MaskUse use, Notes* notes) {
    requirePixels(scene, mask);
    const Segment& segment = requireUnlocked(scene, label);
    Relabelling change(scene, notes);
    const auto inBoth = [&] {
        for (std::size_t i = 0; i < mask.size(); ++i)
            if (mask[i] != 0 && scene.photo->labels[i] == label) return true;
        return false;
    };
    if ((use == MaskUse::TakeFrom || use == MaskUse::Intersect) && !inBoth())
        refuse(Message("messages", "The selection and the segment \"%1\" have no pixel in common.").with(segment.name));
    if (use == MaskUse::Replace || use == MaskUse::Add) change.assign(mask, label);
    const bool selectedGo = use == MaskUse::TakeFrom;
    if (use != MaskUse::Add)
        for (std::size_t i = 0; i < mask.size(); ++i)
            if (change.labels()[i] == label && (mask[i] != 0) == selectedGo) change.labels()[i] = 0;
    return change.finish();
}

Scene duplicateSegment(const Scene& scene, std::uint16_t label, const BinaryMask& mask, Notes* notes) {
    requirePixels(scene, mask);
    Segment copy = requireSegment(scene, label);
    copy.label = requireFreeLabels(scene, 1).front();
    copy.name = SegmentNames(scene).numbered(copy.name, 2);
    Relabelling change(scene, notes);
    change.assign(mask, copy.label);
    change.scene().segments.push_back(std::move(copy));
    return change.finish();
}

Scene mergeSegments(const Scene& scene, std::span<const std::uint16_t> labels, Notes* notes) {
    std::vector<const Segment*> others = requireSegments(scene, labels);
    if (others.size() < 2) refuse(Message("messages", "Select at least two segments to merge them."));
    const Segment& first = requireUnlocked(scene, others.front()->label);
    others.erase(others.begin());
    LabelTable<char> goes(0);
    std::vector<const Segment*> locked, edited;
    for (const Segment* segment : others) {
        if (segment->locked) {
            locked.push_back(segment);
            continue;
        }
        goes[segment->label] = 1;
        if (segment->edit) edited.push_back(segment);
    }
    if (locked.size() == others.size()) refuseLocked(*locked.front());
    noteLocked(notes, locked);
    noteSegments(notes, edited, Message("messages", "The material of \"%1\" is gone: \"%2\" keeps its own."),
                 Message("messages", "The materials of %1 segments are gone: \"%2\" keeps its own."), first.name);
    Relabelling change(scene, notes);
    for (std::uint16_t& pixel : change.labels().pixels())
        if (goes[pixel] != 0) pixel = first.label;
    std::erase_if(change.scene().segments, [&](const Segment& segment) { return goes[segment.label] != 0; });
    return change.finish();
}

Scene splitSegment(const Scene& scene, std::uint16_t label, Notes* notes, const Progress& progress) {
    const Segment& segment = requireUnlocked(scene, label);
    const SegmentPieces pieces = segmentPieces(scene.photo->labels, label, true, progress);
    if (pieces.count == 1) refuse(Message("messages", "The segment \"%1\" is in one piece.").with(segment.name));
    std::vector<std::uint16_t> pieceLabels = requireFreeLabels(scene, pieces.count - 1);
    Relabelling change(scene, notes);
    SegmentNames names(scene);
    for (const std::uint16_t free : pieceLabels) {
        Segment piece = segment;
        piece.label = free;
        piece.name = names.numbered(segment.name, 2);
        change.scene().segments.push_back(std::move(piece));
    }
    pieceLabels.insert(pieceLabels.begin(), label);
    for (std::size_t i = 0; i < pieces.runs.size(); ++i)
        for (int x = pieces.runs[i].x0; x <= pieces.runs[i].x1; ++x)
            change.labels()(x, pieces.runs[i].y) = pieceLabels[pieces.piece[i]];
    return change.finish();
}

Scene deleteSegments(const Scene& scene, std::span<const std::uint16_t> labels, Notes* notes) {
    LabelTable<char> goes(0);
    const std::vector<const Segment*> chosen = requireSegments(scene, labels);
    std::vector<const Segment*> locked;
    for (const Segment* segment : chosen)
        if (segment->locked)
            locked.push_back(segment);
        else
            goes[segment->label] = 1;
    if (!locked.empty() && locked.size() == chosen.size()) refuseLocked(*locked.front());
    noteLocked(notes, locked);
    Relabelling change(scene, notes);
    for (std::uint16_t& pixel : change.labels().pixels())
        if (goes[pixel] != 0) pixel = 0;
    std::erase_if(change.scene().segments, [&](const Segment& segment) { return goes[segment.label] != 0; });
    return change.finish();
}

Scene withSegments(const Scene& scene, const LabelImage& objects, Notes* notes, const std::string& name) {
    std::vector<FoundObject> found = foundObjects(scene, objects);
    std::erase_if(found, [](const FoundObject& object) { return 2 * object.free < object.pixels; });
    if (found.empty()) refuse(Message("messages", "No object was found that is not a segment already."));
    const std::vector<std::uint16_t> free = freeLabels(scene, found.size());
    if (free.empty()) (void)requireFreeLabels(scene, 1);
    if (free.size() < found.size())
        addNote(notes, Message("messages", "No label is free for %1 of the objects.").with(found.size() - free.size()));
    Relabelling change(scene, notes);
    SegmentNames names(scene);
    LabelTable<std::uint16_t> given(0);
    for (std::size_t i = 0; i < free.size(); ++i) {
        given[found[i].label] = free[i];
        change.scene().segments.push_back(segmentCalled(free[i], names.numbered(name, 1)));
    }
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (change.labels()[i] == 0) change.labels()[i] = given[objects[i]];
    return change.finish();
}

Scene withImportedSegments(const Scene& scene, const LabelImage& labels, const std::string& name, Notes* notes) {
    const std::vector<FoundObject> found = foundObjects(scene, labels);
    if (found.empty()) refuse(Message("messages", "There is no object in \"%1\": all of it is 0.").with(name));
    (void)requireFreeLabels(scene, found.size());
    LabelTable<char> taken(0);
    for (const Segment& segment : scene.segments) taken[segment.label] = 1;
    LabelTable<std::uint16_t> given(0);
    if (found.size() > 1)
        for (const FoundObject& object : found)
            if (taken[object.label] == 0) taken[given[object.label] = object.label] = 1;
    Relabelling change(scene, notes);
    SegmentNames names(scene);
    std::size_t next = 1;
    for (const FoundObject& object : found) {
        std::uint16_t& label = given[object.label];
        if (label == 0) {
            while (taken[next] != 0) ++next;
            taken[next] = 1;
            label = static_cast<std::uint16_t>(next);
        }
        const std::string text = found.size() == 1 ? name : name + ' ' + std::to_string(object.label);
        change.scene().segments.push_back(segmentCalled(label, names.free(text)));
    }
    change.assign([&](std::size_t i) { return labels[i] != 0 ? std::optional(given[labels[i]]) : std::nullopt; });
    return change.finish();
}

BinaryMask maskOfSegments(const LabelImage& labels, std::span<const std::uint16_t> chosen) {
    LabelTable<char> wanted(0);
    for (const std::uint16_t label : chosen)
        if (label != 0) wanted[label] = 1;
    BinaryMask mask(labels.width(), labels.height(), 0);
    for (std::size_t i = 0; i < labels.size(); ++i) mask[i] = static_cast<std::uint8_t>(wanted[labels[i]]);
    return mask;
}

}  // namespace core
