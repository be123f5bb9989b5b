import { Eye, LocateFixed, Orbit } from "lucide-preact";
import { texts } from "../../i18n";
import { RadioGroup } from "../../kit/RadioGroup";
import type { SceneTools } from "./tools";
import { CAMERA_MODES, type CameraMode, cameraMode, isSolid, showSolid } from "./view_mode";

const CAMERA_ICONS: Readonly<Record<CameraMode, typeof Eye>> = {
  orbit: Orbit,
  follow: LocateFixed,
  eye: Eye,
};

const OPTION = { kind: "bare" } as const;

/** 2D or 3D. */
export function ViewChoice({ tools }: { tools: SceneTools }) {
  const { solid } = texts.value;
  return (
    <RadioGroup<boolean>
      class="scene__buttons"
      optionClass="scene__button scene__button--text"
      label={solid.view}
      testId="floor-view"
      value={isSolid.value}
      options={[
        [false, solid.flat, { ...OPTION, tip: solid.flatTip }],
        [true, solid.solid, { ...OPTION, tip: solid.solidTip }],
      ]}
      onChange={(isOn) => {
        if (isOn && tools.tool.peek()) tools.toggle(null);
        showSolid(isOn);
      }}
    />
  );
}

/** The camera of a floor in 3D. */
export function CameraChoice() {
  const { solid } = texts.value;
  if (!isSolid.value) return null;
  return (
    <RadioGroup<CameraMode>
      class="scene__buttons scene__cameras"
      optionClass="scene__button"
      label={solid.camera}
      testId="floor-camera"
      value={cameraMode.value}
      options={CAMERA_MODES.map((mode) => {
        const label = solid.cameras[mode];
        return [mode, "", { ...OPTION, icon: CAMERA_ICONS[mode], label, tip: label }];
      })}
      onChange={(mode) => {
        cameraMode.value = mode;
      }}
    />
  );
}
