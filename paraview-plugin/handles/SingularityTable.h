/**
 * @class   SingularityTable
 * @brief   the table of singularities in the panel: k, x, y, radius or z
 *
 * Numbers are shown with three digits, and the quarter index with its sign and colour; numbers that
 * are not edited keep all their digits. One row can be selected.
 */

#ifndef SingularityTable_h
#define SingularityTable_h

#include "SingularityRows.h"

#include <QTableWidget>

#include <vector>

class SingularityTable : public QTableWidget
{
  Q_OBJECT

public:
  explicit SingularityTable(QWidget* parent = nullptr);

  /** Shows rows and highlights the row `chosen`, or none if it is -1. Emits no signal. */
  void ShowRows(const std::vector<SingularityRow>& rows, int chosen);

  /** Hides the column of radii. */
  void HideRadius();

  /** Shows z in the place of the radius. */
  void ShowHeight(bool isShown);

Q_SIGNALS:
  /** Emitted when the user has typed a number. */
  void NumberTyped(int row, int column, double number);
  /** Emitted when the user has selected a row; -1 is none. */
  void RowChosen(int row);

private:
  void UpdateFixedSize(int rows);

  bool HasRadius = true;
};

#endif
