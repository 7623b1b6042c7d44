"""Tables as numpy arrays."""
import tempfile
import unittest
from pathlib import Path

import autoref

_TABLE = """game_id,b.robots,goals_a,shots_a,shootout_a,possession_s_a,state_hash
g-1,5,2,3,,1.5,0012345678901234
g-2,6,0,,,2,00000000000000e1
"""


class Tables(unittest.TestCase):
    """Of a folder with one table."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        Path(self.folder.name, "results.csv").write_text(_TABLE, encoding="utf-8")

    def test_have_a_field_per_column(self):
        table = autoref.results(self.folder.name)
        self.assertEqual(table.dtype.names, tuple(_TABLE.splitlines()[0].split(",")))
        self.assertEqual(table["b.robots"].tolist(), [5, 6])
        self.assertEqual(table["goals_a"].dtype.kind, "i")
        self.assertEqual(table["possession_s_a"].tolist(), [1.5, 2.0])

    def test_keep_hashes_as_texts(self):
        table = autoref.results(self.folder.name)
        self.assertEqual(table["state_hash"].tolist(), ["0012345678901234", "00000000000000e1"])

    def test_have_nan_in_empty_cells(self):
        table = autoref.results(self.folder.name)
        self.assertEqual([str(number) for number in table["shots_a"]], ["3.0", "nan"])
        self.assertEqual([str(number) for number in table["shootout_a"]], ["nan", "nan"])

    def test_have_infinity_at_the_open_end_of_an_interval(self):
        text = "team,bradley_terry_low95,bradley_terry_high95\nbold,1.5,inf\ncalm,-inf,-1.5\nnew,,\n"
        Path(self.folder.name, "standings.csv").write_text(text, encoding="utf-8")
        table = autoref.results(self.folder.name, "standings.csv")
        self.assertEqual([str(number) for number in table["bradley_terry_low95"]], ["1.5", "-inf", "nan"])
        self.assertEqual([str(number) for number in table["bradley_terry_high95"]], ["inf", "-1.5", "nan"])

    def test_may_be_without_rows(self):
        Path(self.folder.name, "results.csv").write_text("game_id,goals_a\n", encoding="utf-8")
        self.assertEqual(len(autoref.results(self.folder.name)), 0)


if __name__ == "__main__":
    unittest.main()
