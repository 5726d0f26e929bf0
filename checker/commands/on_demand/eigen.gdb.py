"""gdb shows Eigen's vectors and matrices as numbers, and does not step into the libraries."""
import gdb
import gdb.printing


class EigenMatrix:
    def __init__(self, value):
        self.value = value
        self.type = value.type.strip_typedefs()

    def shape(self, storage):
        """Rows and columns: fixed ones stand in the type, others in the object (-1 is Eigen's Dynamic)."""
        fixed = [int(self.type.template_argument(k)) for k in (1, 2)]
        return [int(storage[name]) if size < 0 else size for name, size in zip(("m_rows", "m_cols"), fixed)]

    def to_string(self):
        storage = self.value["m_storage"]
        rows, cols = self.shape(storage)
        data = storage["m_data"]
        numbers = data["array"] if data.type.strip_typedefs().code == gdb.TYPE_CODE_STRUCT else data
        by_row = int(self.type.template_argument(3)) & 1
        at = lambda row, col: "%.9g" % float(numbers[row * cols + col if by_row else col * rows + row])
        if cols == 1:
            return "(" + ", ".join(at(row, 0) for row in range(rows)) + ")"
        return "[" + "; ".join(" ".join(at(row, col) for col in range(cols)) for row in range(rows)) + "]"


printers = gdb.printing.RegexpCollectionPrettyPrinter("Eigen")
printers.add_printer("Matrix", "^Eigen::Matrix<double,.*>$", EigenMatrix)
gdb.printing.register_pretty_printer(None, printers, replace=True)
for command in ("set pagination off", "set debuginfod enabled off", "skip -gfi */Eigen/*", "skip -gfi */c++/*"):
    gdb.execute(command, to_string=True)
