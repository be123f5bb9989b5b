import { ArrowDown, CircleCheck, Clock, Footprints } from "lucide-preact";
import { activitiesApi } from "../api/activities";
import type { ActivityChoice, Example } from "../api/model";
import { GoalHands } from "../camera/GoalHands";
import { language, texts } from "../i18n";
import { Button } from "../kit/Button";
import { Loaded } from "../kit/requests/Loaded";
import { useLoaded } from "../kit/requests/useLoaded";
import { GoalPicture } from "../scene/small/GoalPicture";
import { beginActivity } from "../shell/begin_activity";
import { nameInHeader } from "../shell/named";
import type { ParametersOf } from "../shell/route";
import { couldNotOpen, opened } from "../studio/program/open_program";
import { Examples } from "./Examples";

type State = "new" | "tried" | "passed";

interface Offer {
  readonly activities: readonly ActivityChoice[];
  readonly states: ReadonlyMap<string, State>;
  readonly examples: readonly Example[];
}

/** All activities as cards along their paths, and examples. A press opens the group's program for the activity. */
export function ActivitiesScreen({ group }: ParametersOf<"activities">) {
  const offer = useLoaded([group, language.value], () => load(group), { onFailed: couldNotOpen });
  const { activity } = texts.value;
  return (
    <Loaded of={offer} as="screen">
      {({ activities, states, examples }) => (
        <main class="screen activities">
          <div class="row wrap middle apart gap-2">
            <h1>{activity.choose}</h1>
            <Button icon={ArrowDown} testId="to-examples" onPress={showExamples}>
              {texts.value.help.examples.title}
            </Button>
          </div>
          {pathsOf(activities).map(([path, list]) => (
            <section key={path} class="activities__path">
              <h2>{activity.paths[path]}</h2>
              <ol>
                {list.map((one) => (
                  <li key={one.name}>
                    <ActivityCard
                      choice={one}
                      state={states.get(one.name) ?? "new"}
                      group={group}
                    />
                  </li>
                ))}
              </ol>
            </section>
          ))}
          <Examples examples={examples} group={group} />
        </main>
      )}
    </Loaded>
  );
}

async function load(group: string): Promise<Offer> {
  const program = opened.peek()?.program;
  const [activities, tried, examples] = await Promise.all([
    activitiesApi.list(),
    activitiesApi.tried(group),
    activitiesApi.examples(),
    nameInHeader(program?.group_id === group ? program.id : null, group),
  ]);
  const states = tried.map(({ name, passed }): [string, State] => [
    name,
    passed ? "passed" : "tried",
  ]);
  return { activities, states: new Map(states), examples };
}

function showExamples(): void {
  const title = document.getElementById("examples");
  title?.scrollIntoView();
  title?.focus({ preventScroll: true });
}

/** Names of the paths, as in pinel_desktop/activities/model.py; activities of a teacher come last. */
const PATHS = ["moves", "shapes", "decisions", "sensors", "games", "own"] as const;
type Path = (typeof PATHS)[number];

/** The activities by path, without empty paths. */
function pathsOf(activities: readonly ActivityChoice[]): [Path, ActivityChoice[]][] {
  return PATHS.map((path): [Path, ActivityChoice[]] => [
    path,
    activities.filter((one) => pathOf(one) === path),
  ]).filter(([, list]) => list.length > 0);
}

const pathOf = ({ path }: ActivityChoice): Path => PATHS.find((one) => one === path) ?? "own";

const ICONS = { new: null, tried: Footprints, passed: CircleCheck } as const;

interface ActivityCardProps {
  choice: ActivityChoice;
  state: State;
  group: string;
}

function ActivityCard({ choice, state, group }: ActivityCardProps) {
  const { activity } = texts.value;
  const Icon = ICONS[state];
  return (
    <Button
      kind="bare"
      class="activities__card column gap-1"
      testId="activity-card"
      data-activity={choice.name}
      data-state={state}
      onPress={() => beginActivity(group, choice.name)}
    >
      <GoalPicture goal={choice.goal_picture} />
      <strong class="activities__title">
        {choice.number} {choice.title}
      </strong>
      <span class="activities__facts aside">
        {choice.minutes !== null && (
          <span>
            <Clock class="icon" aria-hidden="true" /> {activity.minutes({ n: choice.minutes })}
          </span>
        )}
        <GoalHands goal={choice.goal_picture} />
        {Icon && state !== "new" && (
          <span class="activities__state">
            <Icon class="icon" aria-hidden="true" /> {activity.states[state]}
          </span>
        )}
      </span>
    </Button>
  );
}
