// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/file_filters.hpp"

#include <QCoreApplication>
#include <QStringList>

namespace psicarve::ui {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::Filters)
};

}  // namespace

QString filters_of_files() {
    const QString meshes = QStringLiteral("*.stl *.obj *.ply *.3mf *.off");
    const QString drawings = QStringLiteral("*.svg *.dxf");
    const QString pictures = QStringLiteral("*.png *.jpg *.jpeg *.tif *.tiff *.bmp *.pgm");
    const QString tables = QStringLiteral("*.csv");
    const QString jobs = QStringLiteral("*.job *.psi");
    const QString programs = QStringLiteral("*.ngc *.nc *.gcode *.tap *.cnc");
    const QString recordings = QStringLiteral("*.snap *.trace");
    const QString all = QStringList{meshes, drawings, pictures, tables, jobs, programs, recordings}.join(' ');
    const QStringList filters{Words::tr("All that can be opened (%1)").arg(all),
                              Words::tr("Meshes (%1)").arg(meshes),
                              Words::tr("Drawings (%1)").arg(drawings),
                              Words::tr("Pictures (%1)").arg(pictures),
                              Words::tr("Tables (%1)").arg(tables),
                              Words::tr("Jobs (%1)").arg(jobs),
                              Words::tr("Programs in G-code (%1)").arg(programs),
                              Words::tr("Recordings (%1)").arg(recordings),
                              Words::tr("All files (*)")};
    return filters.join(QStringLiteral(";;"));
}

QString filters_of_programs() {
    return Words::tr("Programs in G-code (%1)").arg(QStringLiteral("*.ngc *.nc *.gcode *.tap *.cnc")) +
           QStringLiteral(";;") + Words::tr("All files (*)");
}

}  // namespace psicarve::ui
