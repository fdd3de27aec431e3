// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool_box.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QPainter>
#include <QSpinBox>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>

#include "core/selection/mask_operations.h"
#include "ui/action.h"
#include "ui/brush_size.h"
#include "ui/tools/tool_registry.h"

namespace ui {

namespace {

constexpr std::size_t kNavigate = 0;
constexpr std::size_t kSmartSelect = 1;
constexpr float kBrushStep = 1.2f;
constexpr int kMaxWidth = 200;

QString missingDepth() {
    return QCoreApplication::translate("ToolRegistry", "It needs depth, which this photograph does not have.");
}

/// A sentence that takes the room there is, and ends in "…" where that is too little.
class HintLabel : public QLabel {
  public:
    explicit HintLabel(QWidget* parent) : QLabel(parent) {
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    }
    [[nodiscard]] QSize sizeHint() const override { return minimumSizeHint(); }
    [[nodiscard]] QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }

  protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter painter(this);
        const QRect place = contentsRect();
        painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter,
                         fontMetrics().elidedText(text(), Qt::ElideRight, place.width()));
    }
};

}  // namespace

ToolBox::ToolBox(Workspace& workspace, Canvas& canvas, QObject* parent)
    : QObject(parent), workspace_(workspace), canvas_(canvas), session_(workspace, canvas) {
    for (const ToolEntry& entry : toolRegistry()) {
        Tool* tool = entry.make(session_, brush_, this);
        connect(tool, &Tool::pointerChanged, this, &ToolBox::refreshPointer);
        connect(tool, &Tool::hintChanged, this, &ToolBox::refresh);
        tools_.push_back(tool);
    }
    connectCanvas();
    connect(&session_, &SelectionSession::changed, this, &ToolBox::refresh);
    connect(&session_.worker(), &SelectionWorker::stateChanged, this, [this] {
        refresh();
        refreshPointer();
    });
    connect(&workspace, &Workspace::documentReplaced, this, &ToolBox::followDocument);
    connect(&workspace, &Workspace::paintingChanged, this, [this] {
        refresh();
        refreshPointer();
    });
}

void ToolBox::connectCanvas() {
    connect(&canvas_, &Canvas::strokeBegan, this, [this](const QPointF& position, Qt::KeyboardModifiers modifiers) {
        if (drawing()) tool().press({position, modifiers});
    });
    connect(&canvas_, &Canvas::doubleClicked, this, [this](const QPointF& position, Qt::KeyboardModifiers modifiers) {
        if (drawing()) tool().doublePress({position, modifiers});
    });
    connect(&canvas_, &Canvas::strokeMoved, this, [this](const QPointF& position) {
        if (drawing()) tool().drag(position);
    });
    connect(&canvas_, &Canvas::strokeEnded, this, [this] {
        if (drawing()) tool().release();
    });
    connect(&canvas_, &Canvas::hovered, this, [this](const QPointF& position, Qt::KeyboardModifiers modifiers) {
        pointer_ = position;
        hovering_ = true;
        if (drawing()) tool().hover({position, modifiers});
    });
    connect(&canvas_, &Canvas::hoverEnded, this, [this] {
        hovering_ = false;
        tool().leave();
    });
}

bool ToolBox::drawing() const { return workspace_.hasPhoto() && workspace_.paintedDrive() == nullptr; }

void ToolBox::fillMenu(QMenu& menu) {
    selectAll_ = makeAction(this, "actionSelectAll", tr("Select &all"), QKeySequence::SelectAll,
                            tr("Select the whole picture"), [this] { session_.selectAll(); });
    clear_ = makeAction(this, "actionClearSelection", tr("&Clear selection"), QKeySequence(Qt::CTRL | Qt::Key_D),
                        tr("Select nothing"), [this] { session_.clear(); });
    menu.addActions({selectAll_, clear_});
    fillOperations(menu);
    menu.addSeparator();
    fillSegmentActions(menu);
    QMenu* tools = menu.addMenu(tr("&Tools"));
    buttons_ = new QActionGroup(this);
    const QColor color = menu.palette().color(QPalette::WindowText);
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        const ToolEntry& entry = toolRegistry()[i];
        QAction* action = makeAction(this, QString::fromUtf8(entry.key), entry.translatedTitle(),
                                     QKeySequence(QString::fromUtf8(entry.shortcut)), entry.translatedHelp(),
                                     [this, i] { activate(i); });
        action->setToolTip(toolTipOf(i));
        action->setCheckable(true);
        action->setIcon(entry.icon(color));
        buttons_->addAction(action);
        tools->addAction(action);
    }
    buttons_->actions().front()->setChecked(true);
}

QString ToolBox::toolTipOf(std::size_t index) const {
    const ToolEntry& entry = toolRegistry()[index];
    const bool missing = entry.needsDepth && workspace_.hasPhoto() && !session_.hasDepth();
    return QStringLiteral("<b>%1</b> (%2)<br>%3")
               .arg(entry.translatedTitle(), QString::fromUtf8(entry.shortcut), entry.translatedHelp()) +
           (missing ? QStringLiteral("<br>") + missingDepth() : QString());
}

QAction* ToolBox::addOperation(QMenu& menu, const QString& key, const QString& text, const QKeySequence& shortcut,
                               const QString& help, Operation operation, bool refines) {
    QString name = text;
    name.remove(QLatin1Char('&'));
    QAction* action =
        makeAction(this, key, text, shortcut, help, [this, name, refines, operation = std::move(operation)] {
            const SelectionSession::Operation change =
                [operation, width = session_.width()](const core::Selector& selector, const core::BinaryMask& selected,
                                                      const core::Progress& progress) {
                    return operation(selector, selected, width, progress);
                };
            refines ? session_.refine(name, change) : session_.change(name, change);
        });
    menu.addAction(action);
    operations_.push_back(action);
    return action;
}

void ToolBox::fillOperations(QMenu& menu) {
    using core::BinaryMask, core::Progress, core::Selector;
    addOperation(menu, "actionInvertSelection", tr("&Invert"), QKeySequence(Qt::CTRL | Qt::Key_I),
                 tr("Select what is not selected"),
                 [](const Selector&, const BinaryMask& mask, int, const Progress&) { return core::invertMask(mask); });
    menu.addSeparator();
    barOperations_.push_back(addOperation(menu, "actionGrowSelection", tr("&Grow"),
                                          QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Plus),
                                          tr("Add a border of the width in the bar above the picture"),
                                          [](const Selector&, const BinaryMask& mask, int width, const Progress&) {
                                              return core::growMask(mask, width);
                                          }));
    barOperations_.push_back(addOperation(menu, "actionShrinkSelection", tr("S&hrink"),
                                          QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Minus),
                                          tr("Take a border of the width in the bar above the picture away"),
                                          [](const Selector&, const BinaryMask& mask, int width, const Progress&) {
                                              return core::shrinkMask(mask, width);
                                          }));
    addOperation(menu, "actionFillSelection", tr("&Fill holes"), {}, tr("Add the areas that the selection encloses"),
                 [](const Selector&, const BinaryMask& mask, int, const Progress&) { return core::fillHoles(mask); });
    addOperation(menu, "actionSmoothSelection", tr("&Smooth"), {},
                 tr("Round the outline off and drop specks, as wide as the bar above the picture says"),
                 [](const Selector&, const BinaryMask& mask, int width, const Progress&) {
                     return core::smoothMask(mask, width);
                 });
    addOperation(
        menu, "actionRefineSelection", tr("&Refine whole edge"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R),
        tr("Find the outline again in the photograph, at most the width in the bar above the picture away"),
        [](const Selector& selector, const BinaryMask& mask, int width, const Progress& progress) {
            return selector.refine(mask, width, progress);
        },
        true);
}

void ToolBox::fillSegmentActions(QMenu& menu) {
    makeSegment_ = makeAction(this, "actionMakeSegment", tr("&New segment"), {},
                              tr("Make a segment of what is selected (Enter)"), [this] { session_.makeSegment(); });
    menu.addAction(makeSegment_);
    operations_.push_back(makeSegment_);
    const auto add = [&](const QString& key, const QString& text, const QString& help, core::MaskUse use) {
        QAction* action = makeAction(this, key, text, {}, help, [this, use] { session_.changeSegment(use); });
        menu.addAction(action);
        segmentChanges_.push_back(action);
    };
    add("actionAddToSegment", tr("Add &to segment"), tr("Add what is selected to the current segment"),
        core::MaskUse::Add);
    add("actionTakeFromSegment", tr("Ta&ke from segment"), tr("Take what is selected away from the current segment"),
        core::MaskUse::TakeFrom);
    add("actionIntersectSegment", tr("Inter&sect with segment"),
        tr("Leave only what is selected of the current segment"), core::MaskUse::Intersect);
    menu.addSeparator();
    findObjects_ = makeAction(this, "actionFindObjects", tr("Find &objects"), {},
                              tr("Make a segment of each object that stands on a table, floor or wall"),
                              [this] { session_.findObjects(); });
    menu.addAction(findObjects_);
    menu.addSeparator();
}

void ToolBox::addUses(QToolBar& bar) {
    struct Use {
        const char* key;
        QString text;
        QString help;
        core::MaskUse use;
    };
    auto* place = new QWidget(&bar);
    auto* layout = new QHBoxLayout(place);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(1);
    uses_ = new QActionGroup(this);
    for (const Use& row :
         {Use{"useReplace", tr("New"), tr("The shape replaces the selection"), core::MaskUse::Replace},
          Use{"useAdd", tr("Add"), tr("The shape is added to the selection (Shift)"), core::MaskUse::Add},
          Use{"useTake", tr("Take away"), tr("The shape is taken from the selection (Alt)"), core::MaskUse::TakeFrom},
          Use{"useIntersect", tr("Intersect"), tr("What the shape and the selection share stays (Shift+Alt)"),
              core::MaskUse::Intersect}}) {
        QAction* action =
            makeAction(this, row.key, row.text, {}, row.help, [this, use = row.use] { session_.setUse(use); });
        action->setCheckable(true);
        action->setData(static_cast<int>(row.use));
        uses_->addAction(action);
        auto* button = new QToolButton(place);
        button->setDefaultAction(action);
        layout->addWidget(button);
    }
    usesPlace_ = bar.addWidget(place);
}

void ToolBox::addBars(QMainWindow& window) {
    auto* bar = new QToolBar(tr("Selection tools"), &window);
    bar->setObjectName(QStringLiteral("selectionTools"));
    bar->setMovable(false);
    bar->setOrientation(Qt::Vertical);
    bar->addActions(buttons_->actions());
    window.addToolBar(Qt::LeftToolBarArea, bar);

    auto* optionBar = new QToolBar(tr("Tool options"), &window);
    optionBar->setObjectName(QStringLiteral("toolOptions"));
    optionBar->setMovable(false);
    name_ = new QLabel(optionBar);
    name_->setObjectName(QStringLiteral("toolName"));
    name_->setContentsMargins(8, 0, 8, 0);
    optionBar->addWidget(name_);
    for (Tool* each : tools_) {
        QWidget* row = each->makeOptions(optionBar);
        options_.push_back(row != nullptr ? optionBar->addWidget(row) : nullptr);
    }
    addUses(*optionBar);
    window.addToolBarBreak();
    window.addToolBar(optionBar);
    window.addToolBarBreak();
    window.addToolBar(makeHintBar(window));
    activate(kNavigate);
}

QToolBar* ToolBox::makeHintBar(QMainWindow& window) {
    auto* bar = new QToolBar(tr("Hint and selection"), &window);
    bar->setObjectName(QStringLiteral("toolHints"));
    bar->setMovable(false);
    hint_ = new HintLabel(bar);
    hint_->setObjectName(QStringLiteral("toolHint"));
    hint_->setContentsMargins(8, 0, 8, 0);
    bar->addWidget(hint_);
    auto* width = new QSpinBox(bar);
    width->setObjectName(QStringLiteral("selectionWidth"));
    width->setAccessibleName(tr("Width for growing, shrinking and smoothing"));
    width->setToolTip(tr("By how many pixels Grow, Shrink, Smooth and Refine whole edge change the outline"));
    width->setRange(1, kMaxWidth);
    width->setSuffix(tr(" px"));
    width->setValue(session_.width());
    connect(width, &QSpinBox::valueChanged, this, [this](int value) { session_.setWidth(value); });
    bar->addWidget(width);
    for (QAction* action : barOperations_) bar->addAction(action);
    bar->addAction(clear_);
    bar->addAction(makeSegment_);
    return bar;
}

void ToolBox::choose(const QString& key) {
    const auto& entries = toolRegistry();
    const auto entry =
        std::ranges::find_if(entries, [&](const ToolEntry& each) { return key == QLatin1String(each.key); });
    CORE_ASSERT(entry != entries.end(), "a tool of the registry");
    activate(static_cast<std::size_t>(entry - entries.begin()));
}

QString ToolBox::chosen() const { return QString::fromUtf8(toolRegistry()[active_].key); }

void ToolBox::activate(std::size_t index) {
    tool().cancel();
    tool().leave();
    active_ = index;
    // The pointer cannot paint a mask and select at once.
    workspace_.setPaintedParameter({});
    buttons_->actions().at(static_cast<qsizetype>(index))->setChecked(true);
    for (std::size_t i = 0; i < options_.size(); ++i)
        if (options_[i] != nullptr) options_[i]->setVisible(i == index);
    refresh();
    refreshPointer();
}

void ToolBox::followDocument() {
    brush_.setMaximum(maxBrushRadius(workspace_.scene()));
    if (buttons_ == nullptr) return;
    const bool nothingToEdit = workspace_.hasPhoto() && workspace_.scene().segments.empty();
    activate(nothingToEdit ? kSmartSelect : kNavigate);
}

void ToolBox::refresh() {
    if (hint_ == nullptr) return;
    const bool photo = workspace_.hasPhoto();
    const bool selected = photo && session_.selection() != nullptr;
    selectAll_->setEnabled(photo);
    clear_->setEnabled(selected);
    findObjects_->setEnabled(photo && session_.hasDepth());
    findObjects_->setToolTip(photo && !session_.hasDepth()
                                 ? findObjects_->statusTip() + QStringLiteral(". ") + missingDepth()
                                 : findObjects_->statusTip());
    for (QAction* action : operations_) action->setEnabled(selected);
    for (QAction* action : segmentChanges_) action->setEnabled(selected && workspace_.selectedSegment() != nullptr);
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        QAction* button = buttons_->actions().at(static_cast<qsizetype>(i));
        button->setEnabled(photo && (!toolRegistry()[i].needsDepth || session_.hasDepth()));
        button->setToolTip(toolTipOf(i));
    }
    usesPlace_->setVisible(tool().drawsShapes());
    // The controls of the other tools need the room.
    const bool options = options_[active_] != nullptr;
    name_->setText(options ? QString() : toolRegistry()[active_].translatedTitle());
    for (QAction* action : uses_->actions())
        action->setChecked(action->data().toInt() == static_cast<int>(session_.use()));
    hint_->setText(!photo                                 ? tr("Open a photograph or a project to begin.")
                   : workspace_.paintedDrive() != nullptr ? tr("Paint where the parameter is to vary; Shift erases. A "
                                                               "tool on the left ends painting.")
                                                          : tool().hint());
    hint_->setToolTip(hint_->text());
}

void ToolBox::refreshPointer() {
    if (!workspace_.hasPhoto()) {
        canvas_.setPointer({});
    } else if (workspace_.paintedDrive() != nullptr) {
        canvas_.setPointer({.strokes = true, .brushRadius = workspace_.brush().radius, .shape = Qt::CrossCursor});
    } else {
        Pointer pointer = tool().pointer();
        if (session_.worker().changing()) pointer.shape = Qt::BusyCursor;
        canvas_.setPointer(pointer);
    }
}

void ToolBox::rehover(Qt::KeyboardModifiers modifiers) {
    if (hovering_ && drawing() && QGuiApplication::mouseButtons() == Qt::NoButton) tool().hover({pointer_, modifiers});
}

bool ToolBox::pressKey(const QKeyEvent& event) {
    if (!workspace_.hasPhoto()) return false;
    switch (event.key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (drawing() && tool().finish()) return true;
            if (session_.selection() == nullptr && !session_.worker().changing()) return false;
            session_.makeSegment();
            return true;
        case Qt::Key_Escape:
            if (tool().cancel()) return true;
            if (session_.worker().changing()) {
                session_.worker().cancel();
                return true;
            }
            if (session_.selection() == nullptr) return false;
            session_.clear();
            return true;
        case Qt::Key_Backspace:
            return tool().takeBack();
        case Qt::Key_BracketLeft:
            return resizeBrush(1 / kBrushStep);
        case Qt::Key_BracketRight:
            return resizeBrush(kBrushStep);
        case Qt::Key_Space:
            canvas_.setHand(true);
            return true;
        case Qt::Key_Alt:
            rehover(event.modifiers() | Qt::AltModifier);
            return false;
        default:
            return false;
    }
}

bool ToolBox::resizeBrush(float factor) {
    if (drawing()) return tool().resize(factor);
    core::Brush brush = workspace_.brush();
    brush.radius = std::clamp(brush.radius * factor, 1.0f, maxBrushRadius(workspace_.scene()));
    workspace_.setBrush(brush);
    return true;
}

bool ToolBox::undo() { return tool().takeBack() || tool().cancel(); }

bool ToolBox::releaseKey(const QKeyEvent& event) {
    if (event.key() == Qt::Key_Space && !event.isAutoRepeat()) {
        canvas_.setHand(false);
        return true;
    }
    if (event.key() == Qt::Key_Alt) rehover(event.modifiers() & ~Qt::KeyboardModifiers(Qt::AltModifier));
    return false;
}

}  // namespace ui
