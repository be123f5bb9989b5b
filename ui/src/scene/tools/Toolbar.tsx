import { useSignal } from "@preact/signals";
import {
  Camera,
  ChevronsLeft,
  LocateFixed,
  Minus,
  Plus,
  Radar,
  Radio,
  RotateCcw,
  Ruler,
  Scan,
  Triangle,
  Wrench,
} from "lucide-preact";
import type { Ring, Robot } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import type { MeasureTool } from "./measure";
import { shownRings, toggleRing } from "./sensor_rings";
import type { SceneTools } from "./tools";
import { ViewChoice } from "./ViewChoice";
import { isSolid } from "./view_mode";

const ZOOM_STEP = 1.4;

/** A floor in 2D or 3D that the buttons move. */
interface FloorView {
  zoom(factor: number): void;
  frame(): void;
  /** Absent in 3D, where a camera follows. */
  follow?(isOn: boolean): void;
}

interface ToolbarProps {
  scene(): FloorView | null;
  tools: SceneTools;
  /** Resets everything to the start; null if the floor has no reset. */
  again: { readonly able: boolean; act(): void } | null;
  /** The robot whose sensors can be displayed; null if none can. */
  sensors: Robot | null;
  onPicture(): void;
}

/** The floor's main buttons, and a menu with the other tools. */
export function Toolbar({ scene, tools, again, sensors, onPicture }: ToolbarProps) {
  const labels = texts.value.scene;
  const open = useSignal(false);
  const act = (what: (now: FloorView) => void) => () => {
    const now = scene();
    if (now) what(now);
  };
  return (
    <div class="scene__tools row top gap-2">
      {open.value && <More tools={tools} scene={scene} sensors={sensors} onPicture={onPicture} />}
      <div class="scene__column">
        <ViewChoice tools={tools} />
        <div class="scene__buttons">
          <Tool label={labels.zoomIn} Icon={Plus} onClick={act((now) => now.zoom(ZOOM_STEP))} />
          <Tool
            label={labels.zoomOut}
            Icon={Minus}
            onClick={act((now) => now.zoom(1 / ZOOM_STEP))}
          />
          <Tool label={labels.fit} Icon={Scan} onClick={act((now) => now.frame())} />
          {again && (
            <Tool
              label={labels.again}
              Icon={RotateCcw}
              testId="start-again"
              disabled={!again.able}
              onClick={() => again.act()}
            />
          )}
          <Tool
            label={open.value ? labels.lessTools : labels.moreTools}
            Icon={open.value ? ChevronsLeft : Wrench}
            testId="scene-tools"
            expanded={open.value}
            onClick={() => {
              open.value = !open.value;
            }}
          />
        </div>
      </div>
    </div>
  );
}

type MoreProps = Pick<ToolbarProps, "scene" | "tools" | "sensors" | "onPicture">;

function More({ scene, tools, sensors, onPicture }: MoreProps) {
  const labels = texts.value.scene;
  const ring = (name: Ring, label: string, Icon: typeof Plus) => (
    <Tool
      label={label}
      Icon={Icon}
      testId="ring"
      name={name}
      pressed={shownRings.value.includes(name)}
      onClick={() => toggleRing(name)}
    />
  );
  return (
    <div class="scene__buttons scene__buttons--more" role="toolbar" aria-label={labels.moreTools}>
      {/* from another side than above, lengths and angles on the floor are not true */}
      {!isSolid.value && <MeasureTools tools={tools} />}
      {sensors && sensors.sonars.length > 0 && ring("sonar", labels.sonar, Radio)}
      {sensors?.laser && ring("lidar", labels.lidar, Radar)}
      {!isSolid.value && (
        <Tool
          label={labels.follow}
          Icon={LocateFixed}
          testId="follow"
          pressed={tools.follow.value}
          onClick={() => scene()?.follow?.(!tools.follow.peek())}
        />
      )}
      <Tool label={labels.picture} Icon={Camera} testId="scene-picture" onClick={onPicture} />
    </div>
  );
}

function MeasureTools({ tools }: Pick<MoreProps, "tools">) {
  const labels = texts.value.scene;
  const measure = (name: MeasureTool, Icon: typeof Plus) => (
    <Tool
      label={labels[name]}
      Icon={Icon}
      testId="measure-tool"
      name={name}
      pressed={tools.tool.value === name}
      onClick={() => tools.toggle(name)}
    />
  );
  return (
    <>
      {measure("ruler", Ruler)}
      {measure("protractor", Triangle)}
    </>
  );
}

interface ToolProps {
  label: string;
  Icon: typeof Plus;
  testId?: string;
  name?: string;
  pressed?: boolean;
  expanded?: boolean;
  disabled?: boolean;
  onClick(): void;
}

function Tool({ label, Icon, testId, name, pressed, expanded, disabled, onClick }: ToolProps) {
  return (
    <Button
      icon={Icon}
      label={label}
      kind="bare"
      class="scene__button"
      pressed={pressed}
      open={expanded}
      disabled={disabled}
      testId={testId}
      data-name={name}
      onPress={onClick}
    />
  );
}
