// SPDX-License-Identifier: BSD-3-Clause
// Numbers for people: four digits, a prefix where the unit takes one.

const PREFIXES = [
  [1e9, "G"],
  [1e6, "M"],
  [1e3, "k"],
  [1, ""],
  [1e-3, "m"],
  [1e-6, "µ"],
];
const PREFIXED = /^(Pa|J|W|N|m|s|B)\b/;
const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** Returns [factor, prefix] with which a number is easy to read. */
function prefixOf(value, unit) {
  const size = Math.abs(value);
  if (!PREFIXED.test(unit) || size === 0 || (size >= 0.01 && size < 1e4)) return [1, ""];
  return PREFIXES.find(([factor]) => size >= factor) ?? PREFIXES[PREFIXES.length - 1];
}

/** Returns a power of ten as text. */
function powerText(exponent) {
  const digits = [...String(Math.abs(exponent))].map((digit) => SUPERSCRIPTS[digit]).join("");
  return `10${exponent < 0 ? "⁻" : ""}${digits}`;
}

/** Returns a number with some digits, without a unit. */
function digitsOf(value, digits = 4) {
  if (value === null || !Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e6 || size < 1e-3)) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    return `${Number(mantissa)} × ${powerText(Number(exponent))}`;
  }
  return String(Number(value.toPrecision(digits)));
}

/** Returns a time of a run as text, with as many decimals as give three digits to the run's end. */
function timeText(time, end) {
  const decimals = end > 0 ? Math.min(Math.max(2 - Math.floor(Math.log10(end)), 0), 9) : 0;
  return `${time.toFixed(decimals)} s`;
}

/** Returns a unit as shown; a number without a unit has none. */
function unitText(unit, prefix = "") {
  return unit === "-" || unit === "" ? "" : `${prefix}${unit}`;
}

/** Returns [number, unit] as texts; `spread` is put behind ±. */
function formatted(value, unit, spread = null) {
  if (value === null || value === undefined) return ["–", ""];
  const [factor, prefix] = prefixOf(value, unit);
  const width = spread === null || spread === undefined ? "" : ` ± ${digitsOf(spread / factor, 2)}`;
  return [`${digitsOf(value / factor)}${width}`, unitText(unit, prefix)];
}

/** Returns the cell of a table with a number; it keeps the full number as data-value. */
function numberCell(value, unit, spread = null, attributes = {}) {
  const [number, shown] = formatted(value, unit, spread);
  return element(
    "td",
    { class: "number", "data-value": value, "data-spread": spread, ...attributes },
    number,
    shown ? element("span", { class: "unit" }, ` ${shown}`) : null,
  );
}
