/**
 * @class   SingularityTable
 * @brief   the table of singularities in the panel: k, x, y, radius
 *
 * Numbers are shown with three digits, and the quarter index with its sign and colour; what is not
 * edited keeps all its digits. One row can be chosen.
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

  /** Shows these rows; the row `chosen` is highlighted, none with -1. Emits nothing. */
  void ShowRows(const std::vector<SingularityRow>& rows, int chosen);

  /** Without the column of radii. */
  void HideRadius();

Q_SIGNALS:
  /** A person has typed a number. */
  void NumberTyped(int row, int column, double number);
  /** A person has chosen a row; -1: none. */
  void RowChosen(int row);

private:
  void AskForSize(int rows);
};

#endif
