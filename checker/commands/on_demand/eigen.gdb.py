"""gdb shows Eigen's vectors and matrices as numbers, computes with them, and does not step into the libraries."""
import ast
import gdb
import gdb.printing
import math
import os


class EigenMatrix:
    def __init__(self, value):
        self.value = value
        self.type = value.type.strip_typedefs()

    def shape(self, storage):
        """Rows and columns: fixed ones stand in the type, others in the object (-1 is Eigen's Dynamic)."""
        fixed = [int(self.type.template_argument(k)) for k in (1, 2)]
        return [int(storage[name]) if size < 0 else size for name, size in zip(("m_rows", "m_cols"), fixed)]

    def numbers(self):
        """Row by row."""
        storage = self.value["m_storage"]
        rows, cols = self.shape(storage)
        data = storage["m_data"]
        numbers = data["array"] if data.type.strip_typedefs().code == gdb.TYPE_CODE_STRUCT else data
        by_row = int(self.type.template_argument(3)) & 1
        return [[float(numbers[row * cols + col if by_row else col * rows + row]) for col in range(cols)]
                for row in range(rows)]

    def to_string(self):
        return str(Matrix(self.numbers()))


class Matrix:
    """What `print` computes with: the numbers of an Eigen matrix, row by row."""

    def __init__(self, rows):
        self.rows = [list(row) for row in rows]

    def __str__(self):
        rows = [["%.9g" % number for number in row] for row in self.rows]
        if rows and len(rows[0]) == 1:
            return "(" + ", ".join(row[0] for row in rows) + ")"
        return "[" + "; ".join(" ".join(row) for row in rows) + "]"

    def flat(self):
        return [number for row in self.rows for number in row]

    def shape(self):
        return len(self.rows), len(self.rows[0]) if self.rows else 0

    def each(self, function):
        return Matrix([function(number) for number in row] for row in self.rows)

    def entrywise(self, other, function):
        if not isinstance(other, Matrix) or self.shape() != other.shape():
            raise gdb.GdbError("These two have different sizes.")
        return Matrix([function(*pair) for pair in zip(*rows)] for rows in zip(self.rows, other.rows))

    def __call__(self, *at):
        row, col = at if len(at) == 2 else (at[0], 0) if self.shape()[1] == 1 else (0, at[0])
        if not (0 <= row < self.shape()[0] and 0 <= col < self.shape()[1]):
            raise gdb.GdbError("There is no entry (%d,%d) in %d×%d." % (row, col, *self.shape()))
        return self.rows[row][col]

    __getitem__ = __call__

    def __mul__(self, other):
        if not isinstance(other, Matrix):
            return self.each(lambda number: number * other)
        if self.shape()[1] != other.shape()[0]:
            raise gdb.GdbError("In this product the left side is %d×%d and the right one %d×%d; a.dot(b) and a.cross(b) "
                               "multiply vectors." % (*self.shape(), *other.shape()))
        return Matrix([sum(x * y for x, y in zip(row, column)) for column in zip(*other.rows)] for row in self.rows)

    def __rmul__(self, number):
        return self * number

    def __truediv__(self, number):
        return self.each(lambda each: each / number if number else math.nan)

    def __add__(self, other):
        return self.entrywise(other, lambda x, y: x + y)

    def __sub__(self, other):
        return self.entrywise(other, lambda x, y: x - y)

    def __neg__(self):
        return self * -1

    def dot(self, other):
        return sum(self.cwiseProduct(other).flat())

    def cross(self, other):
        a, b, after = self.flat(), other.flat(), (1, 2, 0)
        turned = [a[i] * b[after[i]] - a[after[i]] * b[i] for i in range(3)]
        return Matrix([turned[after[i]]] for i in range(3))

    def cwiseProduct(self, other):
        return self.entrywise(other, lambda x, y: x * y)

    def transpose(self):
        return Matrix(zip(*self.rows))

    def squaredNorm(self):
        return self.dot(self)

    def norm(self):
        return math.sqrt(self.squaredNorm())

    def normalized(self):
        return self / self.norm()

    def row(self, index):
        return Matrix([self.rows[index]])

    def col(self, index):
        return Matrix([row[index]] for row in self.rows)

    def sum(self):
        return sum(self.flat())

    def trace(self):
        return sum(row[index] for index, row in enumerate(self.rows))

    def diagonal(self):
        return Matrix([row[index]] for index, row in enumerate(self.rows))

    def determinant(self):
        (a, b, c), rest = self.rows[0], self.rows[1:]
        minor = lambda i, j: rest[0][i] * rest[1][j] - rest[0][j] * rest[1][i]
        return a * minor(1, 2) - b * minor(0, 2) + c * minor(0, 1)

    def x(self):
        return self(0)

    def y(self):
        return self(1)

    def z(self):
        return self(2)


def read(value):
    """A number, a Matrix or a list of them; nothing for what is neither."""
    if value.type.code == gdb.TYPE_CODE_REF:
        value = value.referenced_value()
    type_ = value.type.strip_typedefs().unqualified()
    if type_.code in (gdb.TYPE_CODE_INT, gdb.TYPE_CODE_BOOL):
        return int(value)
    if type_.code == gdb.TYPE_CODE_FLT:
        return float(value)
    if str(type_).startswith("Eigen::Matrix<double,"):
        return Matrix(EigenMatrix(value).numbers())
    if str(type_).startswith("std::vector<"):
        return [read(child) for _, child in gdb.default_visualizer(value).children()]
    return None


def shown(known):
    if isinstance(known, list):
        return ", ".join(map(str, known))
    return str(known) if isinstance(known, Matrix) else "%.9g" % known


class Print(gdb.Command):
    """Print an expression: with vectors and matrices as in C++, for example I*omega, I(0,1), L.norm(), 2*L - a.cross(b)."""

    def __init__(self):
        super().__init__("print", gdb.COMMAND_DATA, gdb.COMPLETE_EXPRESSION)

    def invoke(self, argument, from_tty):
        values = {name: getattr(math, name) for name in ("sin", "cos", "tan", "sqrt", "acos", "asin", "atan2", "pow", "exp")}
        try:
            tree = ast.parse(argument.replace("std::", "").strip(), mode="eval")
            names = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)} - values.keys()
            known = {name: read(gdb.parse_and_eval(name)) for name in names}
        except (SyntaxError, gdb.error):
            known = {}
        if not any(isinstance(value, (Matrix, list)) for value in known.values()):
            try:
                return gdb.execute("call " + argument, from_tty)  # gdb knows all else
            except gdb.error as problem:
                raise gdb.GdbError(str(problem))  # its own words, and no name of an exception of Python
        try:
            result = eval(compile(tree, "print", "eval"), {"__builtins__": {}}, values | known)
        except (TypeError, AttributeError, IndexError, ValueError, ZeroDivisionError) as problem:
            raise gdb.GdbError("This cannot be computed here: %s." % problem)
        gdb.write("%s = %s\n" % (argument.strip(), shown(result)))


def text(value):
    """As `print` shows it."""
    known = read(value)
    if known is not None:
        return shown(known)
    of = str(value.type.strip_typedefs().unqualified())
    is_formula = of.startswith("Eigen::") and not of.startswith("Eigen::Quaternion")
    return "a formula that is computed where it is used (auto)" if is_formula else str(value)


class Compared(gdb.Breakpoint):
    """Where the program of a case has its result."""
    write = staticmethod(gdb.write)

    def __init__(self):
        super().__init__("compared", internal=True)

    def stop(self):
        main = gdb.newest_frame().older()
        for name in ("expected", "yours"):
            self.write("%s = %s\n" % (name, text(main.read_var(name))))
        return False


class Intermediate(gdb.Command):
    """intermediate FUNCTION: runs to the end, and shows every variable of the function where it gets a value."""

    most_steps, most_values = 3000, 4

    def __init__(self):
        super().__init__("intermediate", gdb.COMMAND_RUNNING)

    def variables(self, frame):
        """Those of the function that are in sight, by name; an inner one hides an outer one."""
        found, block = {}, frame.block()
        while block is not None:
            for symbol in block:
                if symbol.is_variable or symbol.is_argument:
                    found.setdefault(symbol.name, symbol)
            block = None if block.function else block.superblock
        return found

    def write(self, words):
        os.write(1, words.encode())  # where gdb's own messages are silenced

    def invoke(self, function, from_tty):
        Compared.write = self.write
        gdb.execute("tbreak " + function)
        gdb.execute("run")
        known, shown, signals, depth = {}, {}, [], self.depth()
        gdb.events.stop.connect(lambda stop: signals.append(stop.stop_signal) if isinstance(stop, gdb.SignalEvent) else None)
        for name, symbol in self.variables(gdb.newest_frame()).items():
            known[name] = text(symbol.value(gdb.newest_frame()))
            if symbol.is_argument:
                self.write("%s = %s\n" % (name, known[name]))
        for _ in range(self.most_steps):
            line = gdb.newest_frame().find_sal().line
            gdb.execute("next")
            if signals:
                return self.write("line %d: the program received %s\n" % (line, signals[0]))
            if self.depth() != depth:
                break
            frame = gdb.newest_frame()
            for name, symbol in self.variables(frame).items():
                value = text(symbol.value(frame))
                if line >= symbol.line and (known.get(name) != value or line == symbol.line):
                    self.show(shown, line, name, value)
                known[name] = value
        for (line, name), values in shown.items():
            if len(values) > self.most_values:
                self.write("line %d, in the end: %s = %s\n" % (line, name, values[-1]))
        if self.depth() == depth:
            gdb.execute("finish")
        if self.depth():
            gdb.execute("continue")

    def show(self, shown, line, name, value):
        values = shown.setdefault((line, name), [])
        values.append(value)
        if len(values) <= self.most_values:
            self.write("line %d: %s = %s\n" % (line, name, value))

    def depth(self):
        """How many functions are under way; 0 once the program is over."""
        try:
            frame, depth = gdb.newest_frame(), 0
        except gdb.error:
            return 0
        while frame is not None:
            frame, depth = frame.older(), depth + 1
        return depth


Print()
Compared()
Intermediate()
printers = gdb.printing.RegexpCollectionPrettyPrinter("Eigen")
printers.add_printer("Matrix", "^Eigen::Matrix<double,.*>$", EigenMatrix)
gdb.printing.register_pretty_printer(None, printers, replace=True)
for command in ("set pagination off", "set debuginfod enabled off", "skip -gfi */Eigen/*", "skip -gfi */c++/*"):
    gdb.execute(command, to_string=True)
