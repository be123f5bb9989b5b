import { useSignal } from "@preact/signals";
import { authoringApi } from "../../api/authoring";
import { type ActivityChoice, type ClassPreset as Preset, worldTitle } from "../../api/model";
import { language, texts } from "../../i18n";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { LabelledSelect, type SelectOption } from "../../kit/Select";
import { LEVELS, levelNames } from "../../shell/level";
import { worlds } from "../../shell/session";
import { SWAP_MINUTES, type SwapMinutes } from "../../shell/swap_timer";
import { asTeacher } from "../../shell/teacher/teacher_session";

interface ClassPresetProps {
  classroom: string;
  preset: Preset;
  activities: readonly ActivityChoice[];
  onChanged(): Promise<void>;
}

/** The preset of a class: settings with which its groups start. Each choice is saved at once. */
export function ClassPreset({ classroom, preset, activities, onChanged }: ClassPresetProps) {
  const { preset: labels } = texts.value.making;
  const { fault, act } = useAction(asTeacher);
  const isSaved = useSignal(false);
  const change = async (changes: Partial<Preset>) => {
    isSaved.value = await act(() => authoringApi.setPreset(classroom, { ...preset, ...changes }));
    await onChanged();
  };
  return (
    <section class="panel card">
      <h2>{labels.title}</h2>
      <p class="teacher__hint">{labels.hint}</p>
      <div class="class-preset">
        <LabelledSelect
          label={labels.level}
          value={preset.level ?? null}
          testId="preset-level"
          options={[[null, labels.free], ...LEVELS.map((one) => [one, levelNames()[one]] as const)]}
          onChange={(level) => change({ level })}
        />
        <LabelledSelect
          label={labels.world}
          value={preset.world ?? null}
          testId="preset-world"
          options={[[null, labels.free], ...worldOptions(activities, labels.worldOf)]}
          onChange={(world) => change({ world })}
        />
        <LabelledSelect
          label={labels.activity}
          value={preset.activity ?? null}
          testId="preset-activity"
          options={[
            [null, labels.free],
            ...activities.map((one) => [one.name, one.title] as const),
          ]}
          onChange={(activity) => change({ activity })}
        />
        <Swap minutes={preset.swap_minutes ?? null} onChange={change} />
        <Album isOff={preset.album === false} onChange={change} />
        <p role="status" data-testid="preset-saved">
          {isSaved.value && labels.saved}
        </p>
      </div>
      <FaultLine fault={fault} />
    </section>
  );
}

interface SwapProps {
  minutes: SwapMinutes | null;
  onChange(changes: Partial<Preset>): Promise<void>;
}

/** The interval of the reminder to swap roles. */
function Swap({ minutes, onChange }: SwapProps) {
  const { making, teacher } = texts.value;
  const labelOf = (one: SwapMinutes) => teacher.computer.turnsEvery[one];
  return (
    <LabelledSelect
      label={making.preset.swap}
      value={minutes}
      testId="preset-swap"
      options={[
        [null, making.preset.ofComputer],
        ...SWAP_MINUTES.map((one) => [one, labelOf(one)] as const),
      ]}
      onChange={(swap_minutes) => onChange({ swap_minutes })}
    />
  );
}

interface AlbumProps {
  isOff: boolean;
  onChange(changes: Partial<Preset>): Promise<void>;
}

/** Whether the groups have an album of stickers. */
function Album({ isOff, onChange }: AlbumProps) {
  const labels = texts.value.album.ofClass;
  return (
    <LabelledSelect
      label={labels.label}
      value={isOff ? "off" : null}
      testId="preset-album"
      options={[
        [null, labels.on],
        ["off", labels.off],
      ]}
      onChange={(chosen) => onChange({ album: chosen ? false : null })}
    />
  );
}

/** Shipped worlds, and the own worlds of activities that were made on this PC. */
function worldOptions(
  activities: readonly ActivityChoice[],
  worldOf: (values: { title: string }) => string,
): SelectOption<string>[] {
  const shipped = new Set(worlds.value.map(({ name }) => name));
  const own = activities.filter((one) => one.own && !shipped.has(one.goal_picture.world.name));
  return [
    ...worlds.value.map((one): SelectOption<string> => [one.name, worldTitle(one, language.value)]),
    ...own.map(({ name, title }): SelectOption<string> => [name, worldOf({ title })]),
  ];
}
