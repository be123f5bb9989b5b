import { type Signal, useComputed, useSignal } from "@preact/signals";
import { Minus, Plus, Scan } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { listen } from "../../kit/listen";
import { liveryOf } from "../../scene/livery/livery";
import { group, robotOf } from "../../shell/session";
import { theme } from "../../shell/theme";
import type { EditorStore } from "../editor_store";
import { pressed } from "../keys";
import { floorPoint, paintBoard, panned, type View, wholeView, zoomed } from "./board_view";
import { FaultNote } from "./FaultNote";
import { Handles } from "./Handles";
import { Outlines } from "./Outlines";

const ZOOM_STEP = 1.4;
/** Minimum pointer movement of a drag, pixels. */
const TREMBLE = 4;

/** The floor to draw on: the scene's picture below SVG elements for the objects to select or drag. */
export function Board({ store, children }: { store: EditorStore; children: ComponentChildren }) {
  const view = useSignal<View | null>(null);
  const byHand = useSignal(false);
  const frame = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  useFitting(frame, store, view, byHand);
  const world = store.world.value;

  useLayoutEffect(() => {
    if (!canvas.current || !view.value) return;
    paintBoard(canvas.current, world, robotOf(null), liveryOf(group.value), view.value);
  }, [world, view.value, theme.value, group.value]);

  return (
    <div class="world-editor__floor column shrinks shrinks-down gap-2">
      <div class="row rigid gap-2">
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
      <div class="scene board grows" ref={frame} data-tool={store.tool.value}>
        <canvas class="scene__canvas" ref={canvas} />
        {view.value && <Overlay store={store} view={view as Signal<View>} byHand={byHand} />}
        {view.value && <FaultNote store={store} view={view.value} />}
      </div>
    </div>
  );
}

/** Fits the whole floor until the user zooms or pans. */
function useFitting(
  frame: { current: HTMLDivElement | null },
  store: EditorStore,
  view: Signal<View | null>,
  byHand: Signal<boolean>,
): void {
  const size = useSignal({ width: 0, height: 0 });
  const floor = useComputed(() => store.shown.value.width * 1000 + store.shown.value.depth);
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
    if (!byHand.value) view.value = wholeView(store.world.peek(), size.value);
    else if (view.value) view.value = { ...view.value, size: size.value };
  }, [size.value, floor.value, byHand.value]);
}

interface OverlayProps {
  store: EditorStore;
  view: Signal<View>;
  byHand: Signal<boolean>;
}

function Overlay({ store, view, byHand }: OverlayProps) {
  const svg = useRef<SVGSVGElement>(null);
  const labels = texts.value.world;
  useLayoutEffect(
    () => (svg.current ? followHand(svg.current, store, view, byHand) : undefined),
    [store, view, byHand],
  );
  const { size, viewport } = view.value;
  return (
    <svg
      ref={svg}
      class="board__overlay"
      viewBox={`0 0 ${size.width} ${size.height}`}
      role="application"
      aria-label={labels.board}
      tabindex={0}
      data-testid="world-board"
      data-camera={`${viewport.x} ${viewport.y} ${viewport.scale}`}
      onKeyDown={(event) => {
        if (!pressed(store, event)) return;
        event.preventDefault();
        // the focused element may have been deleted
        if (!store.selected.value) svg.current?.focus();
      }}
    >
      <Outlines store={store} view={view.value} />
      {store.tool.value === "select" && <Handles store={store} view={view.value} />}
    </svg>
  );
}

/** Turns pointer and wheel events into drags of objects, or else into pan and zoom. */
function followHand(
  svg: SVGSVGElement,
  store: EditorStore,
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
    store.grip(targetOf(event.target), floorAt(event));
  };
  const move = (event: PointerEvent) => {
    if (!from || event.pointerId !== from.pointer) return;
    const now = at(event);
    moved ||= Math.hypot(now.x - from.x, now.y - from.y) > TREMBLE;
    if (!moved) return;
    if (store.isGripping) store.drag(floorAt(event), event.shiftKey);
    else {
      byHand.value = true;
      view.value = panned(view.value, now.x - from.x, now.y - from.y);
      from = { ...now, pointer: from.pointer };
    }
  };
  const up = (event: PointerEvent) => {
    if (event.pointerId !== from?.pointer) return;
    from = null;
    store.endDrag(floorAt(event), moved);
  };
  const cancel = () => {
    from = null;
    store.cancel();
  };
  const wheel = (event: WheelEvent) => {
    event.preventDefault();
    const { x, y } = at(event);
    byHand.value = true;
    view.value = zoomed(view.value, Math.exp(-event.deltaY / 500), x, y);
  };
  // the board handles the keys, so only Tab moves the focus to an element; a press does not
  const preventFocus = (event: MouseEvent) => event.preventDefault();
  const listeners = {
    mousedown: preventFocus,
    pointerdown: down,
    pointermove: move,
    pointerup: up,
    pointercancel: cancel,
    wheel,
  };
  return listen(svg, listeners, { passive: false });
}

function targetOf(target: EventTarget | null): { id?: string; handle?: string } {
  if (!(target instanceof Element)) return {};
  const handle = target.closest<SVGElement>("[data-handle]")?.dataset.handle;
  const id = target.closest<SVGElement>("[data-thing]")?.dataset.thing;
  return { ...(id && { id }), ...(handle && { handle }) };
}

function Buttons({ onZoom, onFit }: { onZoom(factor: number): void; onFit(): void }) {
  const labels = texts.value.scene;
  const button = (label: string, Icon: typeof Plus, act: () => void) => (
    <Button icon={Icon} label={label} kind="bare" class="scene__button" onPress={act} />
  );
  return (
    <div class="world-zoom row rigid">
      {button(labels.zoomIn, Plus, () => onZoom(ZOOM_STEP))}
      {button(labels.zoomOut, Minus, () => onZoom(1 / ZOOM_STEP))}
      {button(labels.fit, Scan, onFit)}
    </div>
  );
}
