// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/masks.h"

#include <algorithm>
#include <string>

#include "core/scene/mask.h"

namespace core {

void requireMasksFit(const Scene& scene, ErrorKind kind) {
    const auto size = [](int w, int h) { return std::to_string(w) + "x" + std::to_string(h); };
    for (const Segment& segment : scene.segments) {
        if (!segment.edit) continue;
        for (const Drive& drive : segment.edit->drives) {
            if (drive.mask == nullptr) continue;
            const LabelImage& labels = scene.photo->labels;
            if (drive.mask->width() == labels.width() && drive.mask->height() == labels.height()) continue;
            throw Error(
                kind,
                Message("messages",
                        "The mask \"%1\" of \"%2\" in segment \"%3\" is %4, expected the photograph's size %5.")
                    .with(drive.mask->path(), drive.parameter, segment.name,
                          size(drive.mask->width(), drive.mask->height()), size(labels.width(), labels.height())));
        }
    }
}

Notes maskNotes(const Scene& scene) {
    Notes notes;
    for (const Segment& segment : scene.segments) {
        if (!segment.edit) continue;
        for (const Drive& drive : segment.edit->drives) {
            if (drive.mask == nullptr || drive.mask->path().empty()) continue;
            const LabelImage& labels = scene.photo->labels;
            float min = 2;
            float max = -1;
            for (int y = 0; y < labels.height(); ++y)
                for (int x = 0; x < labels.width(); ++x) {
                    if (labels(x, y) != segment.label) continue;
                    min = std::min(min, drive.mask->value(x, y));
                    max = std::max(max, drive.mask->value(x, y));
                }
            if (min != max) continue;
            notes.push_back(
                Message("messages",
                        "The mask \"%1\" is %2 everywhere in the segment \"%3\", so \"%4\" does not vary there. Is it "
                        "the mask of another segment?")
                    .with(drive.mask->path(), std::to_string(min).substr(0, 5), segment.name, drive.parameter));
        }
    }
    return notes;
}

}  // namespace core
