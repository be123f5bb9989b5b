import { type Signal, useComputed, useSignal } from "@preact/signals";
import { Minus, Plus, Scan } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { TEST } from "../app/testids";
import { theme } from "../app/theme";
import { texts } from "../i18n";
import { floorPoint, paintBoard, panned, type View, wholeView, zoomed } from "./board_view";
import type { WorldDesk } from "./desk";
import { FaultNote } from "./FaultNote";
import { Handles } from "./Handles";
import { pressed } from "./keys";
import { Outlines } from "./Outlines";

const ZOOM_STEP = 1.4;
/** A hand that trembles has not moved, pixels. */
const TREMBLE = 4;

/** The floor to draw on, under words and buttons of its own: the scene's picture, and over it elements for what can be taken hold of. */
export function Board({ desk, children }: { desk: WorldDesk; children: ComponentChildren }) {
  const view = useSignal<View | null>(null);
  const byHand = useSignal(false);
  const frame = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  useFitting(frame, desk, view, byHand);
  const world = desk.world.value;

  useLayoutEffect(() => {
    if (canvas.current && view.value) paintBoard(canvas.current, world, view.value);
  }, [world, view.value, theme.value]);

  return (
    <div class="world-editor__floor">
      <div class="world-editor__lead">
        {children}
        <Buttons
          onZoom={(factor) => {
            if (!view.value) return;
            const { width, height } = view.value.size;
            byHand.value = true;
            view.value = zoomed(view.value, factor, width / 2, height / 2);
          }}
          onFit={() => {
            byHand.value = false;
          }}
        />
      </div>
      <div class="scene board" ref={frame} data-tool={desk.tool.value}>
        <canvas class="scene__canvas" ref={canvas} />
        {view.value && <Overlay desk={desk} view={view as Signal<View>} byHand={byHand} />}
        {view.value && <FaultNote desk={desk} view={view.value} />}
      </div>
    </div>
  );
}

/** The whole floor is shown until a person zooms or moves it. */
function useFitting(
  frame: { current: HTMLDivElement | null },
  desk: WorldDesk,
  view: Signal<View | null>,
  byHand: Signal<boolean>,
): void {
  const size = useSignal({ width: 0, height: 0 });
  const floor = useComputed(() => desk.shown.value.width * 1000 + desk.shown.value.depth);
  useEffect(() => {
    const element = frame.current;
    if (!element) return;
    const sizes = new ResizeObserver(() => {
      size.value = { width: element.clientWidth, height: element.clientHeight };
    });
    sizes.observe(element);
    return () => sizes.disconnect();
  }, []);
  useLayoutEffect(() => {
    if (size.value.width === 0) return;
    if (!byHand.value) view.value = wholeView(desk.world.peek(), size.value);
    else if (view.value) view.value = { ...view.value, size: size.value };
  }, [size.value, floor.value, byHand.value]);
}

interface OverlayProps {
  desk: WorldDesk;
  view: Signal<View>;
  byHand: Signal<boolean>;
}

function Overlay({ desk, view, byHand }: OverlayProps) {
  const svg = useRef<SVGSVGElement>(null);
  const words = texts.value.world;
  useLayoutEffect(
    () => (svg.current ? followHand(svg.current, desk, view, byHand) : undefined),
    [desk, view, byHand],
  );
  const { size, camera } = view.value;
  return (
    <svg
      ref={svg}
      class="board__overlay"
      viewBox={`0 0 ${size.width} ${size.height}`}
      role="application"
      aria-label={words.board}
      tabindex={0}
      data-testid={TEST.worldBoard}
      data-camera={`${camera.x} ${camera.y} ${camera.scale}`}
      onKeyDown={(event) => {
        if (!pressed(desk, event)) return;
        event.preventDefault();
        // what has the focus may have been deleted
        if (!desk.selected.value) svg.current?.focus();
      }}
    >
      <Outlines desk={desk} view={view.value} />
      {desk.tool.value === "select" && <Handles desk={desk} view={view.value} />}
    </svg>
  );
}

/** Turns what pointer and wheel do into gestures, and into moves of the picture where nothing is taken. */
function followHand(
  svg: SVGSVGElement,
  desk: WorldDesk,
  view: Signal<View>,
  byHand: Signal<boolean>,
): () => void {
  let from: { x: number; y: number; pointer: number } | null = null;
  let moved = false;
  const at = (event: MouseEvent) => {
    const box = svg.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const floorAt = (event: MouseEvent) => {
    const { x, y } = at(event);
    return floorPoint(view.value, x, y);
  };
  const down = (event: PointerEvent) => {
    if (from || event.button !== 0) return;
    svg.setPointerCapture(event.pointerId);
    svg.focus();
    from = { ...at(event), pointer: event.pointerId };
    moved = false;
    desk.grip(targetOf(event.target), floorAt(event));
  };
  const move = (event: PointerEvent) => {
    if (!from || event.pointerId !== from.pointer) return;
    const now = at(event);
    moved ||= Math.hypot(now.x - from.x, now.y - from.y) > TREMBLE;
    if (!moved) return;
    if (desk.isGripping) desk.drag(floorAt(event), event.shiftKey);
    else {
      byHand.value = true;
      view.value = panned(view.value, now.x - from.x, now.y - from.y);
      from = { ...now, pointer: from.pointer };
    }
  };
  const up = (event: PointerEvent) => {
    if (event.pointerId !== from?.pointer) return;
    from = null;
    desk.letGo(floorAt(event), moved);
  };
  const cancel = () => {
    from = null;
    desk.cancel();
  };
  const wheel = (event: WheelEvent) => {
    event.preventDefault();
    const { x, y } = at(event);
    byHand.value = true;
    view.value = zoomed(view.value, Math.exp(-event.deltaY / 500), x, y);
  };
  // the keys are for the board: what is beneath the hand has the focus only where Tab brought it
  const keepFocus = (event: MouseEvent) => event.preventDefault();
  svg.addEventListener("mousedown", keepFocus);
  svg.addEventListener("pointerdown", down);
  svg.addEventListener("pointermove", move);
  svg.addEventListener("pointerup", up);
  svg.addEventListener("pointercancel", cancel);
  svg.addEventListener("wheel", wheel, { passive: false });
  return () => {
    svg.removeEventListener("mousedown", keepFocus);
    svg.removeEventListener("pointerdown", down);
    svg.removeEventListener("pointermove", move);
    svg.removeEventListener("pointerup", up);
    svg.removeEventListener("pointercancel", cancel);
    svg.removeEventListener("wheel", wheel);
  };
}

function targetOf(target: EventTarget | null): { id?: string; handle?: string } {
  if (!(target instanceof Element)) return {};
  const handle = target.closest<SVGElement>("[data-handle]")?.dataset.handle;
  const id = target.closest<SVGElement>("[data-thing]")?.dataset.thing;
  return { ...(id && { id }), ...(handle && { handle }) };
}

function Buttons({ onZoom, onFit }: { onZoom(factor: number): void; onFit(): void }) {
  const words = texts.value.scene;
  const button = (label: string, Icon: typeof Plus, act: () => void) => (
    <button type="button" class="scene__button" aria-label={label} title={label} onClick={act}>
      <Icon class="icon" aria-hidden="true" />
    </button>
  );
  return (
    <div class="world-zoom">
      {button(words.zoomIn, Plus, () => onZoom(ZOOM_STEP))}
      {button(words.zoomOut, Minus, () => onZoom(1 / ZOOM_STEP))}
      {button(words.fit, Scan, onFit)}
    </div>
  );
}
