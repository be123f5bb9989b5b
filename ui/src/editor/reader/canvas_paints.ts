type Ctx = CanvasRenderingContext2D;

/** Paints one part of a block. The canvas is in the block's frame. */
export type Paint = (ctx: Ctx) => void;

/** Decorations of the editor that a picture of a program leaves out. */
const LEFT_OUT = ".blocklyIconGroup";

/** The parts of a drawn block on the page, as paints of a canvas. */
export class BlockPaints {
  readonly paints: Paint[] = [];
  /** The outlines of the block and of all blocks inside it, by block id. */
  readonly outlines = new Map<string, Path2D>();
  private readonly images: Promise<unknown>[] = [];
  private readonly toFrame: DOMMatrix;

  /**
   * @param root - the block's element in the page. Style sheets give its parts their colours and fonts.
   * @param below - the element of the next block, which is inside `root`; null for the last block of a stack.
   */
  constructor(root: SVGGraphicsElement, below: Element | null) {
    this.toFrame = matrixOf(root).inverse();
    this.add(root, below, 1);
  }

  /** Resolves when all images of the block have been decoded; only then may it be painted. */
  async ready(): Promise<void> {
    await Promise.all(this.images);
  }

  private add(element: SVGGraphicsElement, below: Element | null, opacity: number): void {
    const style = getComputedStyle(element);
    if (element === below || element.matches(LEFT_OUT) || isHidden(style)) return;
    const own = opacity * Number(style.opacity || 1);
    this.addPart(element, style, own);
    for (const child of element.children) {
      if (child instanceof SVGGraphicsElement) this.add(child, below, own);
    }
  }

  private addPart(element: SVGGraphicsElement, style: CSSStyleDeclaration, opacity: number): void {
    const paint = this.paintOf(element, style);
    if (!paint) return;
    const matrix = this.toFrame.multiply(matrixOf(element));
    this.paints.push((ctx) => {
      ctx.save();
      ctx.globalAlpha = opacity;
      ctx.transform(matrix.a, matrix.b, matrix.c, matrix.d, matrix.e, matrix.f);
      paint(ctx);
      ctx.restore();
    });
  }

  private paintOf(element: SVGGraphicsElement, style: CSSStyleDeclaration): Paint | null {
    if (element instanceof SVGPathElement) {
      const path = new Path2D(element.getAttribute("d") ?? "");
      this.addOutline(element, path);
      return filled(path, style);
    }
    if (element instanceof SVGRectElement) return filled(roundedBox(element), style);
    if (element instanceof SVGTextElement) return written(element, style);
    if (element instanceof SVGImageElement) return this.imagePaint(element);
    return null;
  }

  private addOutline(element: SVGPathElement, path: Path2D): void {
    const id = element.matches(".blocklyPath") && element.parentElement?.getAttribute("data-id");
    if (!id) return;
    const outline = new Path2D();
    outline.addPath(path, this.toFrame.multiply(matrixOf(element)));
    this.outlines.set(id, outline);
  }

  private imagePaint(element: SVGImageElement): Paint {
    const image = new Image();
    image.src = element.href.baseVal;
    this.images.push(image.decode());
    const [x, y, width, height] = boxOf(element);
    return (ctx) => ctx.drawImage(image, x, y, width, height);
  }
}

const matrixOf = (element: SVGGraphicsElement) => DOMMatrix.fromMatrix(element.getCTM() ?? {});

const isHidden = ({ display, visibility }: CSSStyleDeclaration) =>
  display === "none" || visibility === "hidden";

function filled(path: Path2D, style: CSSStyleDeclaration): Paint {
  const { fill, stroke, strokeWidth } = style;
  return (ctx) => {
    if (fill !== "none") {
      ctx.fillStyle = fill;
      ctx.fill(path);
    }
    if (stroke === "none") return;
    ctx.strokeStyle = stroke;
    ctx.lineWidth = Number.parseFloat(strokeWidth);
    ctx.stroke(path);
  };
}

function roundedBox(element: SVGRectElement): Path2D {
  const path = new Path2D();
  path.roundRect(...boxOf(element), element.rx.baseVal.value);
  return path;
}

function written(element: SVGTextElement, style: CSSStyleDeclaration): Paint {
  const { fill, fontWeight, fontSize, fontFamily, dominantBaseline } = style;
  const text = element.textContent ?? "";
  const [x, y] = [element.x.baseVal[0]?.value ?? 0, element.y.baseVal[0]?.value ?? 0];
  return (ctx) => {
    ctx.fillStyle = fill;
    ctx.font = `${fontWeight} ${fontSize} ${fontFamily}`;
    ctx.textAlign = "left";
    ctx.textBaseline = dominantBaseline === "central" ? "middle" : "alphabetic";
    ctx.fillText(text, x, y);
  };
}

function boxOf({ x, y, width, height }: SVGRectElement | SVGImageElement) {
  return [x.baseVal.value, y.baseVal.value, width.baseVal.value, height.baseVal.value] as const;
}
