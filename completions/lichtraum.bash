# bash completion for lichtraum

_lichtraum() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} joined= prefix=
  # --option=value is three words, or one where somebody took the = out of COMP_WORDBREAKS.
  if [[ $current == --*=* ]]; then
    joined=yes prefix=${current%%=*}= previous=${current%%=*} current=${current#*=}
  elif [[ $current == = ]]; then
    joined=yes current=
  elif [[ $previous == = ]]; then
    joined=yes previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  _lichtraum_reply
  COMPREPLY=("${COMPREPLY[@]/#/$prefix}")
}

# What may stand for `current` after `previous`, which is an option's name where they are `joined`.
_lichtraum_reply() {
  local commands='render view preview thumbnail job denoise check info explain devices doctor'
  local general='-q --quiet -v --verbose -h --help'
  local language='--strict --keep-going --transform-order --rotation --material-extras --allow-path --scene --variant --time --animation --both-sides --max-texture --point-size'
  COMPREPLY=()

  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "$commands help --help --version" -- "$current")
    return
  fi

  local values=
  case $previous in
    --format-in) values='sdf gltf glb obj ply stl' ;;
    --format) values='png ppm jpg exr pfm' ;;
    --graphics) values='auto blocks kitty sixel' ;;
    --bits) values='8 16' ;;
    --planes) values='radiance alpha depth normal albedo position object instance material radiance,alpha,depth,normal' ;;
    --background) values='none environment 0,0,0 1,1,1 0.4,0.4,0.4,0.1,0.1,0.1' ;;
    --environment)
      compopt -o filenames 2> /dev/null
      mapfile -t COMPREPLY < <(compgen -W 'studio none' -- "$current"; compgen -f -- "$current")
      return
      ;;
    --environment-rotation) values='0 90 180 270' ;;
    --environment-brightness) values='0.5 1 2' ;;
    --denoise) values='auto on off builtin' ;;
    --up) values='0,1,0 0,0,1' ;;
    --orbit) values='35,20 0,0 90,0 0,90' ;;
    --fov-x | --fov-y) values='25 45 60' ;;
    --clamp) values='1 3 10' ;;
    --noise) values='0.02 0.05 0.1' ;;
    --exposure) values='-2 -1 1 2' ;;
    --tonemap) values='auto neutral agx aces reinhard none' ;;
    --transfer) values='linear srgb' ;;
    --traversal) values='auto scalar wide packet' ;;
    --transform-order) values='parent local' ;;
    --rotation) values='right left' ;;
    --material-extras) values='reflectance transmittance opacity ior ignore' ;;
    --device) values='cpu gpu reference' ;;
    --integrator) values='whitted path' ;;
    --samples) values='1 2x2 4x4 8x8 16 64' ;;
    --size)
      values='640x480 1280x720 1920x1080 3840x2160'
      [[ ${COMP_WORDS[1]} != thumbnail ]] || values='128 256 512 1024'
      ;;
    --output-dir | --allow-path)
      compopt -o filenames 2> /dev/null
      mapfile -t COMPREPLY < <(compgen -d -- "$current")
      return
      ;;
    -o | --output)
      compopt -o filenames 2> /dev/null
      mapfile -t COMPREPLY < <(compgen -f -- "$current")
      return
      ;;
    --ground) [[ -z $joined ]] || values='matt glossy none' ;;
    --frames | --fps | --turntable | --quality | --region | --camera | --eye | --look-at | --root | --depth | --seed) return ;;
  esac
  if [[ -n $values ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$values" -- "$current")
    return
  fi

  if [[ $current == -* ]]; then
    local options=$general view='--eye --look-at --up --orbit --fov-x --fov-y --orthographic --aperture --focus'
    case ${COMP_WORDS[1]} in
      render | check)
        options+=" $language --format-in -o --output --format --output-dir --bits --quality --ppm-ascii --json --size --region"
        options+=" --camera $view --root --planes --integrator --samples --depth --clamp --seed --ground --ground=glossy --background --exposure --tonemap"
        options+=' --transfer --noise --denoise --device --traversal --frames --fps --turntable --environment'
        options+=' --environment-rotation --environment-brightness'
        [[ ${COMP_WORDS[1]} == check ]] || options+=' --resume --show'
        ;;
      view)
        options+=" $language --watch --ui-scale --size --camera $view --root --integrator --samples --depth --clamp --seed --ground --ground=glossy --background"
        options+=' --exposure --tonemap --transfer --denoise --device --traversal --environment --environment-rotation'
        options+=' --environment-brightness'
        ;;
      preview) options+=" $language --format-in --size --graphics --camera $view --root --samples --device" ;;
      thumbnail) options+=' --size --device' ;;
      job)
        options='-h --help'
        case ${COMP_WORDS[2]} in
          plan)
            options="$general $language -o --output --tile --samples-per-unit --size --region --planes --bits --quality --ppm-ascii"
            options+=" --camera $view --root --integrator --samples --depth --clamp --seed --ground --ground=glossy --background --exposure"
            options+=' --tonemap --transfer --denoise --device --traversal --frames --fps --turntable --environment'
            options+=' --environment-rotation --environment-brightness'
            ;;
          work) options="$general --units --device --allow-mixed" ;;
          script) options="$general --units-per-task" ;;
          status) options="$general --json" ;;
          merge) options="$general -o --output --format --output-dir --fps --allow-mixed" ;;
        esac
        ;;
      denoise) options+=' -o --output --exposure --tonemap --transfer --denoise --prefilter --device' ;;
      info) options+=" $language --format-in --json" ;;
      devices) options+=' --json' ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
    return
  fi

  if [[ ${COMP_WORDS[1]} == job ]] && ((COMP_CWORD == 2)); then
    mapfile -t COMPREPLY < <(compgen -W 'plan work status merge script' -- "$current")
    return
  fi
  case ${COMP_WORDS[1]} in
    job)
      if [[ ${COMP_WORDS[2]} == script ]] && ((COMP_CWORD == 3)); then
        mapfile -t COMPREPLY < <(compgen -W 'slurm openjd opencue flamenco parallel' -- "$current")
        return
      fi
      compopt -o filenames 2> /dev/null
      mapfile -t COMPREPLY < <(compgen -f -- "$current")
      ;;
    render | view | preview | thumbnail | check | info) # scenes, and folders on the way to them
      compopt -o filenames 2> /dev/null
      mapfile -t COMPREPLY < <(
        compgen -d -- "$current"
        compgen -f -- "$current" | grep -E '\.(e?sdf|txt|gltf|glb|obj|ply|stl)$'
      )
      ;;
    denoise)
      compopt -o filenames 2> /dev/null
      mapfile -t COMPREPLY < <(
        compgen -d -- "$current"
        compgen -f -- "$current" | grep -E '\.exr$'
      )
      ;;
    explain) mapfile -t COMPREPLY < <(compgen -W "$(lichtraum explain 2> /dev/null | grep -oE '^  [EW][0-9]+')" -- "${current^^}") ;;
    help) mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$current") ;;
  esac
}
complete -F _lichtraum lichtraum
