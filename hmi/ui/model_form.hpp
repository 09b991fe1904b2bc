// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <functional>
#include <memory>

#include "hmi/cam/job_builder.hpp"
#include "hmi/flat/load_model.hpp"
#include "hmi/session/remedy.hpp"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;

namespace psicarve::ui {

class EngraveForm;
class PassForm;
class PictureForm;
struct Tokens;

/// How a model stands in the machine, and how it is sliced: what `psicarve slice` takes as options. Its
/// members: a widget for each option.
class ModelForm : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::ModelForm)
public:
    /// `replaced` is called when the model would stand elsewhere, or have another size.
    /// `reshaped`, when a drawing or picture would become another body.
    ModelForm(std::function<void()> replaced, std::function<void()> reshaped, QWidget* parent = nullptr);
    ~ModelForm() override;

    /// Shows what such a model takes; what is for a drawing or picture alone is as for a new one.
    void begin(flat::ModelKind kind, bool is_engraved = false);
    /// A mesh takes its size from what fits: no height, no scale.
    void set_fits(bool fits);
    /// A table takes tool, blank, passes and joining; the rest is locked.
    void set_table(bool is_table);
    /// Sets the field that it names; nothing where that is no field of this form.
    void take(const session::Remedy& remedy);
    bool is_engraved() const;
    /// Of a drawing or picture on this machine.
    flat::FlatOptions flat_options(const Profile& machine) const;
    cam::JobOptions options() const;
    /// The machine's, with the tool, the blank and the passes that were chosen here.
    Profile profile_for(Profile machine) const;
    /// Draws what tool, blank and passes come to on this machine. At screen rate.
    void show_passes(const Profile& machine);
    /// What that draws; a child of the form's until it is put elsewhere.
    QWidget* pass_picture() const;
    void set_theme(const Tokens& tokens);

private:
    void add_placement();
    void add_slicing();
    void add_tool();
    QDoubleSpinBox* length_field(const char* name, const QString& special);
    void show_what_applies();
    void lock_sizes();
    Profile with_tool_and_blank(Profile machine) const;
    void note_tool();

    std::function<void()> replaced_;
    std::function<void()> reshaped_;
    flat::ModelKind kind_ = flat::ModelKind::mesh;
    bool is_told_ = true;
    bool fits_ = false;
    bool is_table_ = false;
    QFormLayout* form_;
    QComboBox* up_;
    QComboBox* axis_;
    QDoubleSpinBox* axis_x_;
    QDoubleSpinBox* axis_y_;
    QDoubleSpinBox* height_;
    QDoubleSpinBox* scale_;
    EngraveForm* engraving_;
    PictureForm* picture_;
    QSpinBox* layers_;
    QSpinBox* points_;
    QComboBox* joining_;
    QComboBox* tool_;
    QDoubleSpinBox* tool_diameter_;
    QDoubleSpinBox* tool_angle_;
    QDoubleSpinBox* tool_flute_;
    QDoubleSpinBox* blank_radius_;
    QDoubleSpinBox* blank_height_;
    QDoubleSpinBox* blank_x_;
    QDoubleSpinBox* blank_z_;
    QDoubleSpinBox* depth_limit_;
    std::unique_ptr<PassForm> passes_;
};

}  // namespace psicarve::ui
