// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/model_form.hpp"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSpinBox>

#include <algorithm>
#include <thread>
#include <utility>

#include "hmi/ui/choice_box.hpp"
#include "hmi/ui/engrave_form.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/lock_with.hpp"
#include "hmi/ui/pass_form.hpp"
#include "hmi/ui/picture_form.hpp"

namespace psicarve::ui {
namespace {

constexpr int kMostLayers = 100'000;
constexpr int kMostPoints = 100'000;
constexpr int kUsualCount = 500;
constexpr double kMost_mm = 10'000.0;
constexpr double kMostScale = 10'000.0;
constexpr int kScaleDecimals = 4;
constexpr double kMostTool_mm = 100.0;
constexpr double kMostFlute_mm = 1'000.0;
constexpr double kLeastTool_mm = 0.01;
constexpr double kLeastAngle_deg = 1.0;
constexpr double kMostAngle_deg = 179.0;

}  // namespace

ModelForm::ModelForm(std::function<void()> replaced, std::function<void()> reshaped, QWidget* parent)
    : QWidget(parent),
      replaced_(std::move(replaced)),
      reshaped_(std::move(reshaped)),
      form_(new QFormLayout{this}) {
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setVerticalSpacing(kSmallGap);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form_->setRowWrapPolicy(QFormLayout::WrapLongRows);  // words are longer in other languages
    add_placement();
    add_slicing();
    add_tool();
    passes_ = std::make_unique<PassForm>(*form_, *this);
    show_what_applies();
}

ModelForm::~ModelForm() = default;

QDoubleSpinBox* ModelForm::length_field(const char* name, const QString& special) {
    auto* field = new QDoubleSpinBox;
    ignore_wheel(field);
    field->setObjectName(name);
    field->setRange(0.0, kMost_mm);
    field->setSpecialValueText(special);
    field->setSuffix(" mm");
    field->setKeyboardTracking(false);
    return field;
}

void ModelForm::add_placement() {
    up_ = new ChoiceBox;
    up_->setObjectName("up");
    up_->addItems({"Z", "Y", "X"});
    axis_ = new ChoiceBox;
    axis_->setObjectName("axis_at");
    axis_->addItem(tr("box centre"), static_cast<int>(cam::AxisAt::centre));
    axis_->addItem(tr("file's origin"), static_cast<int>(cam::AxisAt::origin));
    axis_->addItem(tr("least lost"), static_cast<int>(cam::AxisAt::best));
    axis_->addItem(tr("a place"), static_cast<int>(cam::AxisAt::point));
    axis_x_ = length_field("axis_x", {});
    axis_y_ = length_field("axis_y", {});
    for (QDoubleSpinBox* place : {axis_x_, axis_y_}) {
        place->setRange(-kMost_mm, kMost_mm);
        place->setSuffix({});  // in the file's units, whatever they are
    }
    height_ = length_field("height", tr("as in the file"));
    scale_ = length_field("scale", tr("as in the file"));
    scale_->setRange(0.0, kMostScale);
    scale_->setDecimals(kScaleDecimals);
    scale_->setSuffix({});
    form_->addRow(tr("Up axis"), up_);
    form_->addRow(tr("Axis at"), axis_);
    form_->addRow(QStringLiteral("X"), axis_x_);
    form_->addRow(QStringLiteral("Y"), axis_y_);
    form_->addRow(tr("Height"), height_);
    form_->addRow(tr("Scale"), scale_);
    engraving_ = new EngraveForm{[this] {
        show_what_applies();
        reshaped_();
    }};
    form_->addRow(engraving_);
    picture_ = new PictureForm{[this] { reshaped_(); }};
    form_->addRow(picture_);
    const auto changed = [this] {
        show_what_applies();
        if (is_told_) replaced_();
    };
    // Of a mesh they scale what is there.
    const auto resized = [this] {
        show_what_applies();
        if (is_told_) (kind_ == flat::ModelKind::mesh ? replaced_ : reshaped_)();
    };
    connect(axis_, &QComboBox::currentIndexChanged, this, changed);
    connect(up_, &QComboBox::currentIndexChanged, this, [this] {
        if (is_told_ && kind_ == flat::ModelKind::mesh) replaced_();
    });
    for (QDoubleSpinBox* field : {axis_x_, axis_y_})
        connect(field, &QDoubleSpinBox::valueChanged, this, changed);
    for (QDoubleSpinBox* field : {height_, scale_})
        connect(field, &QDoubleSpinBox::valueChanged, this, resized);
}

void ModelForm::add_slicing() {
    layers_ = new QSpinBox;
    layers_->setRange(1, kMostLayers);
    layers_->setObjectName("layers");
    points_ = new QSpinBox;
    points_->setRange(2, kMostPoints);
    points_->setObjectName("points");
    for (QSpinBox* count : {layers_, points_}) {
        ignore_wheel(count);
        count->setValue(kUsualCount);
    }
    joining_ = new ChoiceBox;
    joining_->setObjectName("joining");
    joining_->addItem(tr("as the profile"), QString{});
    joining_->addItem(tr("continuous"), QStringLiteral("continuous"));
    joining_->addItem(tr("zigzag"), QStringLiteral("zigzag"));
    joining_->addItem(tr("spiral"), QStringLiteral("spiral"));
    form_->addRow(tr("Layers"), layers_);
    form_->addRow(tr("Points / head"), points_);
    form_->addRow(tr("Joining"), joining_);
}

void ModelForm::add_tool() {
    tool_ = new ChoiceBox;
    tool_->setObjectName("tool");
    tool_->addItem(tr("as the profile"), -1);
    tool_->addItem(tr("a point"), static_cast<int>(ToolShape::point));
    tool_->addItem(tr("ball"), static_cast<int>(ToolShape::ball));
    tool_->addItem(tr("flat"), static_cast<int>(ToolShape::flat));
    tool_->addItem(tr("V"), static_cast<int>(ToolShape::vee));
    tool_diameter_ = length_field("tool_diameter", {});
    tool_diameter_->setRange(kLeastTool_mm, kMostTool_mm);
    tool_diameter_->setValue(ToolProfile{}.diameter_mm);
    tool_angle_ = length_field("tool_angle", {});
    tool_angle_->setRange(kLeastAngle_deg, kMostAngle_deg);
    tool_angle_->setValue(ToolProfile{}.angle_deg);
    tool_angle_->setSuffix(" °");
    tool_flute_ = length_field("tool_flute", tr("as the profile"));
    tool_flute_->setRange(0.0, kMostFlute_mm);
    tool_flute_->setToolTip(tr("How deep the tool can cut"));
    blank_radius_ = length_field("blank_radius", tr("as the profile"));
    blank_height_ = length_field("blank_height", tr("as the profile"));
    blank_x_ = length_field("blank_x", {});
    blank_z_ = length_field("blank_z", {});
    for (QDoubleSpinBox* off : {blank_x_, blank_z_}) off->setRange(-kMost_mm, kMost_mm);
    blank_x_->setToolTip(tr("Where the blank's axis stands off the table's, towards direction 0°"));
    blank_z_->setToolTip(tr("Where the blank's axis stands off the table's, towards direction 90°"));
    depth_limit_ = length_field("depth_limit", tr("as the profile"));
    depth_limit_->setToolTip(tr("No tip goes deeper than this below the blank's surface"));
    form_->addRow(tr("Tool"), tool_);
    form_->addRow(tr("Diameter"), tool_diameter_);
    form_->addRow(tr("Angle"), tool_angle_);
    form_->addRow(tr("Flute length"), tool_flute_);
    form_->addRow(tr("Blank radius"), blank_radius_);
    form_->addRow(tr("Blank height"), blank_height_);
    form_->addRow(tr("Blank off, 0°"), blank_x_);
    form_->addRow(tr("Blank off, 90°"), blank_z_);
    form_->addRow(tr("Depth limit"), depth_limit_);
    connect(tool_, &QComboBox::currentIndexChanged, this, [this] { note_tool(); });
    for (QDoubleSpinBox* field : {blank_radius_, tool_diameter_, tool_angle_})
        connect(field, &QDoubleSpinBox::valueChanged, this, [this] { note_tool(); });
}

bool ModelForm::is_engraved() const {
    return kind_ == flat::ModelKind::drawing && engraving_->is_chosen();
}

/// Grooves are what the tool leaves of the blank.
void ModelForm::note_tool() {
    show_what_applies();
    if (is_told_ && is_engraved()) reshaped_();
}

void ModelForm::set_fits(bool fits) {
    fits_ = fits;
    show_what_applies();
}

void ModelForm::set_table(bool is_table) {
    is_table_ = is_table;
    show_what_applies();
}

void ModelForm::begin(flat::ModelKind kind, bool is_engraved) {
    is_told_ = false;
    const bool is_other = kind != kind_;
    kind_ = kind;
    if (is_other || kind != flat::ModelKind::mesh) {
        height_->setValue(0.0);
        scale_->setValue(0.0);
    }
    engraving_->begin_anew(is_engraved);
    picture_->begin_anew();
    axis_->setItemText(0, kind == flat::ModelKind::drawing ? tr("centroid") : tr("box centre"));
    show_what_applies();
    is_told_ = true;
}

void ModelForm::take(const session::Remedy& remedy) {
    switch (remedy.kind) {
        case session::Remedy::Kind::height:
            scale_->setValue(0.0);
            height_->setValue(remedy.value);
            return;
        case session::Remedy::Kind::scale:
            height_->setValue(0.0);
            scale_->setValue(remedy.value);
            return;
        case session::Remedy::Kind::layers:
            layers_->setValue(static_cast<int>(remedy.value));
            return;
        case session::Remedy::Kind::best_axis:
            axis_->setCurrentIndex(axis_->findData(static_cast<int>(cam::AxisAt::best)));
            return;
        case session::Remedy::Kind::core_profile:
            return;
    }
}

flat::FlatOptions ModelForm::flat_options(const Profile& machine) const {
    flat::FlatOptions options;
    if (height_->value() > 0.0) options.height_mm = height_->value();
    if (kind_ == flat::ModelKind::drawing && scale_->value() > 0.0) options.scale = scale_->value();
    if (kind_ == flat::ModelKind::drawing) engraving_->fill(options, profile_for(machine));
    if (kind_ == flat::ModelKind::picture) picture_->fill(options);
    return options;
}

/// What does not apply takes no room; a height and a scale at once would contradict each other.
void ModelForm::show_what_applies() {
    const bool is_mesh = kind_ == flat::ModelKind::mesh;
    const bool is_picture = kind_ == flat::ModelKind::picture;
    form_->setRowVisible(up_, is_mesh);
    const bool has_axis = !is_picture && !is_engraved();
    form_->setRowVisible(axis_, has_axis);
    form_->setRowVisible(scale_, !is_picture);
    form_->setRowVisible(engraving_, kind_ == flat::ModelKind::drawing);
    form_->setRowVisible(picture_, is_picture);
    const bool is_place = has_axis && axis_->currentData().toInt() == static_cast<int>(cam::AxisAt::point);
    form_->setRowVisible(axis_x_, is_place);
    form_->setRowVisible(axis_y_, is_place);
    height_->setSpecialValueText(is_mesh                       ? tr("as in the file")
                                 : is_picture || is_engraved() ? tr("as its shape")
                                                               : tr("%1 mm").arg(flat::kUsualHeight_mm));
    lock_sizes();
    const int shape = tool_->currentData().toInt();
    form_->setRowVisible(tool_diameter_, shape > static_cast<int>(ToolShape::point));
    form_->setRowVisible(tool_angle_, shape == static_cast<int>(ToolShape::vee));
    form_->setRowVisible(tool_flute_, shape > static_cast<int>(ToolShape::point));
    for (QDoubleSpinBox* of_blank : {blank_height_, blank_x_, blank_z_, depth_limit_})
        form_->setRowVisible(of_blank, blank_radius_->value() > 0.0);
}

/// What a table has of itself, and of height and scale the one that the other sets.
void ModelForm::lock_sizes() {
    const bool is_mesh = kind_ == flat::ModelKind::mesh;
    const QString reason = is_table_ ? tr("A table's layers and radii are taken as they stand") : QString{};
    for (QWidget* field :
         {static_cast<QWidget*>(up_), static_cast<QWidget*>(axis_), static_cast<QWidget*>(axis_x_),
          static_cast<QWidget*>(axis_y_), static_cast<QWidget*>(layers_), static_cast<QWidget*>(points_)})
        lock_with(*field, reason);
    const auto reason_for = [&](const QDoubleSpinBox& other, const QString& other_sets_it) {
        if (is_table_) return reason;
        if (is_mesh && fits_) return tr("Largest sets it");
        return is_mesh && other.value() > 0.0 ? other_sets_it : QString{};
    };
    lock_with(*height_, reason_for(*scale_, tr("Scale sets it")),
              is_mesh ? tr("Scales the model, uniformly") : tr("Of the body that becomes of it"));
    lock_with(*scale_, reason_for(*height_, tr("Height sets it")), tr("mm for each unit of the file"));
}

cam::JobOptions ModelForm::options() const {
    constexpr slice::Up kUps[] = {slice::Up::z, slice::Up::y, slice::Up::x};
    cam::JobOptions options;
    // Others stand as they are; what was chosen is for the next mesh.
    options.up = kind_ == flat::ModelKind::mesh ? kUps[up_->currentIndex()] : slice::Up::z;
    if (kind_ != flat::ModelKind::picture && !is_engraved())
        options.axis_at = static_cast<cam::AxisAt>(axis_->currentData().toInt());
    options.axis_x = axis_x_->value();
    options.axis_y = axis_y_->value();
    // The body of a drawing or picture has its size already.
    if (kind_ == flat::ModelKind::mesh && height_->value() > 0.0) {
        options.height_mm = height_->value();
    } else if (kind_ == flat::ModelKind::mesh && scale_->value() > 0.0) {
        options.scale = scale_->value();
    }
    // The usual numbers give way to a model with fewer pulses of height.
    if (layers_->value() != kUsualCount) options.layer_count = static_cast<std::uint32_t>(layers_->value());
    if (points_->value() != kUsualCount) options.point_count = static_cast<std::uint32_t>(points_->value());
    options.joining = joining_from_name(joining_->currentData().toString().toStdString());
    // One is left for the window, and for a core on the same computer.
    options.thread_count = std::max(1U, std::thread::hardware_concurrency() / 2);
    return options;
}

Profile ModelForm::profile_for(Profile machine) const {
    Profile profile = with_tool_and_blank(std::move(machine));
    passes_->fill(profile);
    return profile;
}

void ModelForm::show_passes(const Profile& machine) {
    passes_->show_for(with_tool_and_blank(machine));
}

QWidget* ModelForm::pass_picture() const {
    return passes_->picture();
}

void ModelForm::set_theme(const Tokens& tokens) {
    passes_->set_theme(tokens);
}

Profile ModelForm::with_tool_and_blank(Profile machine) const {
    const int shape = tool_->currentData().toInt();
    if (shape >= 0) {
        machine.tool.shape = static_cast<ToolShape>(shape);
        machine.tool.diameter_mm = tool_diameter_->value();
        machine.tool.angle_deg = tool_angle_->value();
        if (tool_flute_->value() > 0.0) machine.tool.flute_mm = tool_flute_->value();
    }
    if (!(blank_radius_->value() > 0.0)) return machine;
    machine.blank.radius_mm = blank_radius_->value();
    // Another blank than the profile's stands where it is said to stand.
    machine.blank.offset_x_mm = blank_x_->value();
    machine.blank.offset_z_mm = blank_z_->value();
    if (blank_height_->value() > 0.0) machine.blank.height_mm = blank_height_->value();
    if (depth_limit_->value() > 0.0) machine.blank.depth_limit_mm = depth_limit_->value();
    return machine;
}

}  // namespace psicarve::ui
