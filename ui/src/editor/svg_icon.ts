const SVG = "http://www.w3.org/2000/svg";

/** A stroked picture of 24 x 24; the style sheet gives it colour and size. */
export function svgIcon(shape: string, className: string): SVGElement {
  const svg = document.createElementNS(SVG, "svg");
  svg.classList.add(className);
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS(SVG, "path");
  path.setAttribute("d", shape);
  svg.append(path);
  return svg;
}
