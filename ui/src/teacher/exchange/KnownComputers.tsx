import type { KnownComputerList } from "../../api/model";
import { language, texts } from "../../i18n";
import { relativeTime } from "../../i18n/format";
import { usePolling } from "../../kit/usePolling";
import { Unconfirmed } from "./Unconfirmed";

interface KnownComputersProps {
  knownComputers: KnownComputerList;
  /** Loads the list again. */
  onAgain(): Promise<void>;
}

/** The PCs whose work this PC has, with the time of the last merge. */
export function KnownComputers({ knownComputers, onAgain }: KnownComputersProps) {
  const { computers, unconfirmed } = knownComputers;
  usePolling(onAgain, { isOn: unconfirmed.waiting > 0 });
  const labels = texts.value.exchange;
  const now = new Date();
  const at = (iso: string) => relativeTime(iso, now, language.value, texts.value);
  return (
    <section class="panel card" aria-labelledby="exchange-heard">
      <h2 id="exchange-heard">{labels.heard}</h2>
      <Unconfirmed counts={unconfirmed} />
      {computers.length === 0 ? (
        <p class="exchange__hint">{labels.heardNobody}</p>
      ) : (
        <>
          <table class="exchange__table">
            <thead>
              <tr>
                <th scope="col">{labels.computer}</th>
                <th scope="col">{labels.exported}</th>
                <th scope="col">{labels.merged}</th>
                <th scope="col" class="exchange__number">
                  {labels.heardRuns}
                </th>
              </tr>
            </thead>
            <tbody>
              {computers.map((one) => (
                <tr key={one.computer_id}>
                  <th scope="row">{one.name}</th>
                  <td>{at(one.exported_at)}</td>
                  <td>{at(one.merged_at)}</td>
                  <td class="exchange__number">{one.n_runs}</td>
                </tr>
              ))}
            </tbody>
          </table>
          <p class="exchange__hint">{labels.clock}</p>
        </>
      )}
    </section>
  );
}
