const SVG = "http://www.w3.org/2000/svg";

/** A stroked 24 x 24 icon; the style sheet sets its colour and size. */
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
