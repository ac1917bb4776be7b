"""Turns data/cards.json into the constant tables of src/deck/layout_table.hpp.

usage: card_table.py cards.json out.inc

Every condition and count becomes postfix code over the fields of its keyword; aliases, shared lists
and equal layouts are resolved here, so that the reader knows one regular form only.
"""
import ast
import json
import re
import sys

CODES = ["number", "field", "same_text", "add", "subtract", "multiply", "divide", "negate", "absolute",
         "equal", "differ", "less", "less_equal", "greater", "greater_equal", "both", "either", "invert",
         "choose", "line_fields", "line_starts", "rows"]
BINARY = {ast.Add: "add", ast.Sub: "subtract", ast.Mult: "multiply", ast.Div: "divide", ast.Eq: "equal",
          ast.NotEq: "differ", ast.Lt: "less", ast.LtE: "less_equal", ast.Gt: "greater",
          ast.GtE: "greater_equal", ast.And: "both", ast.Or: "either"}

ops, fields, items, options, keywords, aliases = [], [], [], [], [], []


def text(value):
    return json.dumps(value if value is not None else "", ensure_ascii=True)


class Layout:
    """The fields of one keyword, numbered from 0 in reading order."""

    def __init__(self, name):
        self.name, self.first = name, len(fields)

    def find(self, name):
        for i in range(len(fields) - 1, self.first - 1, -1):  # the nearest line above wins
            if name in fields[i]["name"].split("/"):
                return i - self.first
        raise SystemExit(f"{self.name}: no field {name}")

    def compile(self, expression):
        """Appends postfix code; returns (first, count)."""
        first = len(ops)
        self.visit(ast.parse(expression, mode="eval").body, expression)
        return first, len(ops) - first

    def emit(self, code, number=0.0, argument=0, word=""):
        ops.append((CODES.index(code), number, argument, word))

    def visit(self, n, source):
        if isinstance(n, ast.Constant):
            self.emit("number", float(n.value))
        elif isinstance(n, ast.Name):
            self.emit("field", argument=self.find(n.id))
        elif isinstance(n, ast.BinOp):
            self.visit(n.left, source), self.visit(n.right, source), self.emit(BINARY[type(n.op)])
        elif isinstance(n, ast.UnaryOp):
            self.visit(n.operand, source)
            self.emit("negate" if isinstance(n.op, ast.USub) else "invert")
        elif isinstance(n, ast.BoolOp):
            self.visit(n.values[0], source)
            for v in n.values[1:]:
                self.visit(v, source), self.emit(BINARY[type(n.op)])
        elif isinstance(n, ast.IfExp):
            self.visit(n.test, source), self.visit(n.body, source), self.visit(n.orelse, source)
            self.emit("choose")
        elif isinstance(n, ast.Compare):
            self.compare(n, source)
        elif isinstance(n, ast.Call) and n.func.id == "abs":
            self.visit(n.args[0], source), self.emit("absolute")
        elif isinstance(n, ast.Call) and n.func.id == "next_line_fields":
            self.emit("line_fields")
        elif isinstance(n, ast.Call) and n.func.id == "next_line_starts":
            self.emit("line_starts", word=n.args[0].value)
        elif isinstance(n, ast.Call) and n.func.id == "rows":
            self.emit("rows", argument=self.find(n.args[0].id))
        else:
            raise SystemExit(f"{self.name}: cannot read the condition {source!r}")

    def compare(self, n, source):
        left = n.left
        for i, (op, right) in enumerate(zip(n.ops, n.comparators)):
            if isinstance(op, ast.In):
                for k, element in enumerate(right.elts):
                    self.visit(left, source), self.visit(element, source), self.emit("equal")
                    if k:
                        self.emit("either")
            elif isinstance(right, ast.Constant) and isinstance(right.value, str):
                self.emit("same_text", argument=self.find(left.id), word=right.value)
            else:
                self.visit(left, source), self.visit(right, source), self.emit(BINARY[type(op)])
            if i:
                self.emit("both")
            left = right


def add_fields(line):
    """Numbers the columns of a line for the comma, the 10-column and the fixed format."""
    first, comma, column, column10 = len(fields), 0, 0, 0
    for name, offset, width, kind, default, meaning in line:
        gap = offset - column
        if gap < 0:
            raise SystemExit(f"columns overlap at {name}")
        while gap > 0:  # unnamed columns count as fields in comma lines
            step = min(gap, max(width, 10) if gap >= 10 else gap)
            comma, column10, gap = comma + 1, column10 + max(step, 10), gap - step
        wide = width > 20
        if name != "-":
            fields.append(dict(name=name, offset=offset, width=width, comma=comma, offset10=column10,
                               width10=max(width, 10), long_width=2 * width if wide else 20, kind=kind,
                               default=default, meaning=meaning))
        comma, column, column10 = comma + 1, offset + width, column10 + max(width, 10)
    return first, len(fields) - first


def add_items(layout, cards):
    count = 0
    for card in cards:
        item = dict(kind="line", first=0, count=0, when=(0, 0), repeat=(0, 0), per_line=0, width=0, children=0,
                    to_end=0, optional=int(bool(card.get("optional"))), wrap=int(bool(card.get("wrap"))))
        items.append(item)
        position, count = len(items), count + 1
        own_condition = "when" in card
        repeat = card.get("count") if "series" in card else card.get("repeat")
        if own_condition:
            item["when"] = layout.compile(card["when"])
        if repeat == "end" or "text" in card:
            item["to_end"] = 1
        elif repeat is not None:
            item["repeat"] = layout.compile(repeat)
        if "group" in card:
            item["kind"] = "group"
            add_items(layout, card["group"])
            item["children"] = len(items) - position
        elif "series" in card:
            name, per_line, width, kind, meaning = card["series"]
            item.update(kind="series", first=len(fields) - layout.first, count=1, per_line=per_line, width=width)
            fields.append(dict(name=name, offset=0, width=width, comma=0, offset10=0, width10=max(width, 10),
                               long_width=20, kind=kind, default=None, meaning=meaning))
        elif "text" in card:
            item.update(kind="text", first=len(fields) - layout.first, count=1)
            fields.append(dict(name=card["text"], offset=0, width=80, comma=0, offset10=0, width10=80,
                               long_width=160, kind="A", default=None, meaning="text, every line"))
        else:
            first, number = add_fields(card["fields"])
            item.update(first=first - layout.first, count=number)
    return count


def main(source, target):
    data = json.load(open(source, encoding="utf-8"))
    table = data["keywords"]

    def resolve(x):
        return data["shared"][x[1:]] if isinstance(x, str) else x

    for name in sorted(n for n in table if "same_as" not in table[n]):
        entry = table[name]
        layout = Layout(name)
        lines, option_rows = [], []
        own = resolve(entry.get("options", []))
        # lines before the cards first: conditions look at the fields above them
        for option in [o for o in own if o["place"] == "before"]:
            option_rows.append((option, len(items)))
            add_items(layout, option["cards"])
        first_item = len(items)
        add_items(layout, entry.get("cards", []))
        item_count = len(items) - first_item
        for option in [o for o in own if o["place"] == "after"]:
            option_rows.append((option, len(items)))
            add_items(layout, option["cards"])
        ends = sorted([s for _, s in option_rows] + [first_item, len(items)])
        first_option = len(options)
        for option, start in option_rows:
            stop = next((e for e in ends if e > start), start) if option["cards"] else start
            options.append((option.get("suffix") or "", option.get("optional_card") or "", option["place"] == "before",
                            start, stop - start))
        keywords.append((name, first_item, item_count, first_option, len(options) - first_option, layout.first,
                         len(fields) - layout.first, bool(entry.get("repeat_set")),
                         entry.get("note") or "", entry.get("slides") or ""))
    index = {k[0]: i for i, k in enumerate(keywords)}
    for name, entry in table.items():
        if "same_as" in entry:
            aliases.append((name, index[entry["same_as"]]))
        for alias in entry.get("alias", []):
            aliases.append((re.sub(r"^\*", "", alias).upper(), index[name]))
    aliases.sort()

    out = ["// Written by cmake/card_table.py from data/cards.json; do not edit.", "constexpr Op op_table[] = {"]
    out += [f"{{Code({c}),{number!r},{argument},{text(word)}}}," for c, number, argument, word in ops]
    out += ["};", "constexpr Field field_table[] = {"]
    for f in fields:
        default, kind = f["default"], f["kind"]
        has = default is not None
        number = float(default) if has and kind != "A" else 0.0
        word = str(default) if has and kind == "A" else ""
        out.append(f"{{{text(f['name'])},{f['offset']},{f['width']},{f['comma']},{f['offset10']},{f['width10']},"
                   f"{f['long_width']},'{kind}',{str(has).lower()},{number!r},{text(word)},{text(f['meaning'])}}},")
    out += ["};", "constexpr Item item_table[] = {"]
    for i in items:
        out.append(f"{{Kind::{i['kind']},{i['first']},{i['count']},{i['when'][0]},{i['when'][1]},{i['repeat'][0]},"
                   f"{i['repeat'][1]},{i['per_line']},{i['width']},{i['children']},"
                   + ",".join("true" if i[k] else "false" for k in ("to_end", "optional", "wrap")) + "},")
    out += ["};", "constexpr Option option_table[] = {"]
    out += [f"{{{text(s)},{text(l)},{str(b).lower()},{a},{n}}}," for s, l, b, a, n in options]
    out += ["};", "constexpr Keyword keyword_table[] = {"]
    out += [f"{{{text(n)},{a},{b},{c},{e},{g},{h},{str(r).lower()},{text(note)},{text(slides)}}},"
            for n, a, b, c, e, g, h, r, note, slides in keywords]
    out += ["};", "constexpr Alias alias_table[] = {"]
    out += [f"{{{text(n)},{i}}}," for n, i in aliases]
    out += ["};", ""]
    with open(target, "w", encoding="ascii") as file:
        file.write("\n".join(out))


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
